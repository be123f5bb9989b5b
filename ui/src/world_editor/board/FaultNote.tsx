import { TriangleAlert } from "lucide-preact";
import { TEST } from "../app/testids";
import type { View } from "./board_view";
import type { WorldDesk } from "./desk";
import { onBoard, spanOf } from "./outline";
import { type Plan, thingOf } from "./plan";

/** Off the element that it speaks of, clear of its handles; and the note itself. Pixels. */
const GAP = 48;
const WIDE = 250;
const HIGH = 110;

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
  const span = thing ? spanOf(view, thing) : startSpan(view, plan);
  const isAbove = span.top - GAP > HIGH;
  const left = Math.min(view.size.width - WIDE / 2 - 8, Math.max(WIDE / 2 + 8, span.x));
  return (
    <p
      class={`fault-note ${isAbove ? "" : "fault-note--below"}`}
      style={{ left: `${left}px`, top: `${isAbove ? span.top - GAP : span.bottom + GAP}px` }}
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

function startSpan(view: View, plan: Plan) {
  const { x, y } = onBoard(view, plan.start);
  return { x, top: y, bottom: y };
}
