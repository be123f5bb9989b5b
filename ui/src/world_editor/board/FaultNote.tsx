import { TriangleAlert } from "lucide-preact";
import type { EditorStore } from "../editor_store";
import { type FloorPlan, objectOf } from "../plan";
import type { View } from "./board_view";
import { onBoard, spanOf } from "./outline";

/** Distance between the note and its object, outside the handles, and size of the note; pixels. */
const GAP = 48;
const WIDE = 250;
const HIGH = 110;

/** Note with the fault of the selected object, else the first fault, placed at its object. */
export function FaultNote({ store, view }: { store: EditorStore; view: View }) {
  const { value: faults } = store.faults;
  const { value: selected } = store.selected;
  const placed = faults.filter((fault) => store.aboutFault(fault) !== null);
  const fault = placed.find((one) => store.aboutFault(one) === selected) ?? placed[0];
  if (!fault || store.isGripping) return null;
  const plan = store.shown.value;
  const about = store.aboutFault(fault);
  const object = objectOf(plan, about);
  const span = object ? spanOf(view, object) : startSpan(view, plan);
  const isAbove = span.top - GAP > HIGH;
  const left = Math.min(view.size.width - WIDE / 2 - 8, Math.max(WIDE / 2 + 8, span.x));
  return (
    <p
      class={`fault-note row top gap-2 ${isAbove ? "" : "fault-note--below"}`}
      style={{ left: `${left}px`, top: `${isAbove ? span.top - GAP : span.bottom + GAP}px` }}
      data-testid="world-fault-note"
      aria-hidden="true"
    >
      <TriangleAlert class="icon" aria-hidden="true" />
      <span>
        <strong>{fault.message}</strong> {fault.remedy}
      </span>
    </p>
  );
}

function startSpan(view: View, plan: FloorPlan) {
  const { x, y } = onBoard(view, plan.start);
  return { x, top: y, bottom: y };
}
