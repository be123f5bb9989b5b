import { cornersOf } from "../../scene/areas";
import type { XY } from "../../scene/frames";
import type { EditorStore } from "../editor_store";
import { turnedBy } from "../geometry";
import { type AreaObject, type FloorPlan, isArea, objectOf, type WorldObject } from "../plan";
import type { View } from "./board_view";
import { onBoard } from "./outline";

/** Visible radius and touch radius of a handle, pixels. */
const DOT = 8;
const REACH = 20;
/** Distance of the turning handle from the object's edge, pixels. */
const ARM = 34;

interface Handle {
  readonly name: string;
  readonly at: XY;
  /** Start of the turning handle's arm. */
  readonly root?: XY;
}

/** Handles that resize and turn the selected object. */
export function Handles({ store, view }: { store: EditorStore; view: View }) {
  const handles = handlesOf(store.shown.value, store.selected.value, view);
  return (
    <g>
      {handles.map(({ name, at, root }) => (
        <g
          key={name}
          data-handle={name}
          data-testid="world-handle"
          class={`handle handle--${name}`}
        >
          {root && <line class="handle__arm" x1={root.x} y1={root.y} x2={at.x} y2={at.y} />}
          <circle class="handle__reach" cx={at.x} cy={at.y} r={REACH} />
          <circle class="handle__dot" cx={at.x} cy={at.y} r={DOT} />
        </g>
      ))}
    </g>
  );
}

function handlesOf(plan: FloorPlan, selected: string | null, view: View): Handle[] {
  const object = objectOf(plan, selected);
  if (object) return handlesOfObject(object, view);
  if (selected !== "start") return [];
  const { heading } = plan.start;
  return [turnHandle(view, plan.start, heading, 0.3)];
}

function handlesOfObject(object: WorldObject, view: View): Handle[] {
  if (!isArea(object)) {
    return [
      { name: "from", at: onBoard(view, object.from) },
      { name: "to", at: onBoard(view, object.to) },
    ];
  }
  if (object.radius !== null) return [radiusHandle(object, object.radius, view)];
  const corners = cornersOf(object).map((corner, index) => ({
    name: `${index}`,
    at: onBoard(view, corner),
  }));
  return [...corners, turnHandle(view, object, object.heading, object.width / 2)];
}

const radiusHandle = (object: AreaObject, radius: number, view: View): Handle => ({
  name: "radius",
  at: onBoard(view, { x: object.x + radius, y: object.y }),
});

/** The turning handle, ahead of the object in its heading. */
function turnHandle(view: View, middle: XY, heading: number, reach: number): Handle {
  const along = (metres: number) => {
    const offset = turnedBy({ x: metres, y: 0 }, heading);
    return onBoard(view, { x: middle.x + offset.x, y: middle.y + offset.y });
  };
  return { name: "turn", root: along(reach), at: along(reach + ARM / view.viewport.scale) };
}
