import { useComputed } from "@preact/signals";
import { texts } from "../../i18n";
import type { EditorStore } from "../editor_store";
import { isOuter, ofKind, type Thing } from "../plan";
import { nameOf } from "../words";
import type { View } from "./board_view";
import { edgeOf, onBoard } from "./outline";

/** Touch radius of the robot in metres, and its minimum in pixels. */
const ROBOT_M = 0.3;
const FINGER_PX = 18;

interface OutlinesProps {
  store: EditorStore;
  view: View;
}

/** An element for each thing, which can be clicked and reached with Tab, and is marked when it has a fault. */
export function Outlines({ store, view }: OutlinesProps) {
  const plan = store.shown.value;
  const faulty = useComputed(() => new Set(store.faults.value.map((one) => store.aboutFault(one))));
  // drawing order: paint below, walls on top
  const order = ["paint", "zone", "box", "wall"] as const;
  const things = order.flatMap((kind) =>
    ofKind(plan, kind).map((thing, index) => ({ thing, index })),
  );
  return (
    <g>
      {things.map(
        ({ thing, index }) =>
          !isOuter(plan, thing) && (
            <Outline
              key={thing.id}
              store={store}
              view={view}
              thing={thing}
              index={index}
              isFaulty={faulty.value.has(thing.id)}
            />
          ),
      )}
      <StartOutline store={store} view={view} isFaulty={faulty.value.has("start")} />
    </g>
  );
}

interface OutlineProps extends OutlinesProps {
  thing: Thing;
  /** Index in its list of the document. */
  index: number;
  isFaulty: boolean;
}

function Outline({ store, view, thing, index, isFaulty }: OutlineProps) {
  const isSelected = store.selected.value === thing.id;
  const path = edgeOf(view, thing);
  return (
    // biome-ignore lint/a11y/useSemanticElements: an SVG has no button
    <g
      class={classes(thing.kind, isSelected, isFaulty)}
      role="button"
      tabindex={0}
      aria-label={nameOf(thing, index, texts.value.world)}
      aria-pressed={isSelected}
      data-thing={thing.id}
      data-kind={thing.kind}
      data-index={index}
      data-faulty={isFaulty}
      data-testid="world-thing"
      onFocus={() => store.select(thing.id)}
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
  const r = Math.max(FINGER_PX, ROBOT_M * view.camera.scale);
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
