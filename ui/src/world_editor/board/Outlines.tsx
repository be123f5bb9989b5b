import { useComputed } from "@preact/signals";
import { texts } from "../../i18n";
import type { EditorStore } from "../editor_store";
import { nameOf } from "../labels";
import { isOuter, ofKind, type WorldObject } from "../plan";
import type { View } from "./board_view";
import { edgeOf, onBoard } from "./outline";

/** Touch radius of the robot in metres, and its minimum in pixels. */
const ROBOT_M = 0.3;
const FINGER_PX = 18;

interface OutlinesProps {
  store: EditorStore;
  view: View;
}

/** An element for each object: can be clicked and reached with Tab, and is marked if it has a fault. */
export function Outlines({ store, view }: OutlinesProps) {
  const plan = store.shown.value;
  const faulty = useComputed(() => new Set(store.faults.value.map((one) => store.aboutFault(one))));
  // drawing order: prints below, walls on top
  const order = ["print", "paint", "zone", "box", "wall"] as const;
  const objects = order.flatMap((kind) =>
    ofKind(plan, kind).map((object, index) => ({ object, index })),
  );
  return (
    <g>
      {objects.map(
        ({ object, index }) =>
          !isOuter(plan, object) && (
            <Outline
              key={object.id}
              store={store}
              view={view}
              object={object}
              index={index}
              isFaulty={faulty.value.has(object.id)}
            />
          ),
      )}
      <StartOutline store={store} view={view} isFaulty={faulty.value.has("start")} />
    </g>
  );
}

interface OutlineProps extends OutlinesProps {
  object: WorldObject;
  /** Index of the object in its list of the document. */
  index: number;
  isFaulty: boolean;
}

function Outline({ store, view, object, index, isFaulty }: OutlineProps) {
  const isSelected = store.selected.value === object.id;
  const path = edgeOf(view, object);
  return (
    // biome-ignore lint/a11y/useSemanticElements: an SVG has no button
    <g
      class={classes(object.kind, isSelected, isFaulty)}
      role="button"
      tabindex={0}
      aria-label={nameOf(object, index, texts.value.world)}
      aria-pressed={isSelected}
      data-thing={object.id}
      data-kind={object.kind}
      data-index={index}
      data-faulty={isFaulty}
      data-testid="world-thing"
      onFocus={() => store.select(object.id)}
    >
      <path class="outline__reach" d={path} />
      <path class="outline__line" d={path} />
    </g>
  );
}

interface StartOutlineProps extends OutlinesProps {
  isFaulty: boolean;
}

function StartOutline({ store, view, isFaulty }: StartOutlineProps) {
  const { x, y } = onBoard(view, store.shown.value.start);
  const isSelected = store.selected.value === "start";
  const r = Math.max(FINGER_PX, ROBOT_M * view.viewport.scale);
  return (
    // biome-ignore lint/a11y/useSemanticElements: an SVG has no button
    <g
      class={classes("start", isSelected, isFaulty)}
      role="button"
      tabindex={0}
      aria-label={texts.value.world.kinds.start}
      aria-pressed={isSelected}
      data-thing="start"
      data-kind="start"
      data-faulty={isFaulty}
      data-testid="world-thing"
      onFocus={() => store.select("start")}
    >
      <circle class="outline__reach" cx={x} cy={y} r={r} />
      <circle class="outline__line" cx={x} cy={y} r={r} />
    </g>
  );
}

const classes = (kind: string, isSelected: boolean, isFaulty: boolean) =>
  `outline outline--${kind} ${isSelected ? "outline--selected" : ""} ${isFaulty ? "outline--faulty" : ""}`;
