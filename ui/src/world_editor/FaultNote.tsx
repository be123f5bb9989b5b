import { TriangleAlert } from "lucide-preact";
import { TEST } from "../app/testids";
import type { View } from "./board_view";
import type { WorldDesk } from "./desk";
import { onBoard, topOf } from "./outline";
import { thingOf } from "./plan";

/** Off the element that it speaks of, and off the board's edges; pixels. */
const GAP = 16;
const WIDE = 250;
const HIGH = 70;

/** What is wrong with the selected thing, or with the first, said where it is. */
export function FaultNote({ desk, view }: { desk: WorldDesk; view: View }) {
  const { value: faults } = desk.faults;
  const { value: selected } = desk.selected;
  const placed = faults.filter((fault) => desk.aboutFault(fault) !== null);
  const fault = placed.find((one) => desk.aboutFault(one) === selected) ?? placed[0];
  if (!fault || desk.isGripping) return null;
  const plan = desk.shown.value;
  const about = desk.aboutFault(fault);
  const thing = thingOf(plan, about);
  const at = thing ? topOf(view, thing) : onBoard(view, plan.start);
  const gap = thing ? GAP : GAP + 24;
  const isAbove = at.y - gap > HIGH;
  const left = Math.min(view.size.width - WIDE / 2 - 8, Math.max(WIDE / 2 + 8, at.x));
  return (
    <p
      class={`fault-note ${isAbove ? "" : "fault-note--below"}`}
      style={{ left: `${left}px`, top: `${isAbove ? at.y - gap : at.y + gap + 24}px` }}
      data-testid={TEST.worldFaultNote}
      aria-hidden="true"
    >
      <TriangleAlert class="icon" aria-hidden="true" />
      <span>
        <strong>{fault.message}</strong> {fault.remedy}
      </span>
    </p>
  );
}
