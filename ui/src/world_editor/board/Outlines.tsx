import { useComputed } from "@preact/signals";
import { TEST } from "../app/testids";
import { texts } from "../i18n";
import type { View } from "./board_view";
import type { WorldDesk } from "./desk";
import { onBoard, outlineOf } from "./outline";
import { isOuter, ofKind, type Thing } from "./plan";
import { nameOf } from "./words";

/** From the middle of the robot to where a hand takes it, metres; and never less than a fingertip, pixels. */
const ROBOT_M = 0.3;
const FINGER_PX = 18;

interface OutlinesProps {
  desk: WorldDesk;
  view: View;
}

/** An element for each thing, to be clicked, reached with Tab, and marked where there is something wrong. */
export function Outlines({ desk, view }: OutlinesProps) {
  const plan = desk.shown.value;
  const faulty = useComputed(() => new Set(desk.faults.value.map((one) => desk.aboutFault(one))));
  // as they are drawn: paint beneath, walls on top
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
              desk={desk}
              view={view}
              thing={thing}
              index={index}
              isFaulty={faulty.value.has(thing.id)}
            />
          ),
      )}
      <StartOutline desk={desk} view={view} isFaulty={faulty.value.has("start")} />
    </g>
  );
}

interface OutlineProps extends OutlinesProps {
  thing: Thing;
  /** Its place in the list of the document that holds it. */
  index: number;
  isFaulty: boolean;
}

function Outline({ desk, view, thing, index, isFaulty }: OutlineProps) {
  const isSelected = desk.selected.value === thing.id;
  const path = outlineOf(view, thing);
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
      data-testid={TEST.worldThing}
      onFocus={() => desk.select(thing.id)}
    >
      <path class="outline__reach" d={path} />
      <path class="outline__line" d={path} />
    </g>
  );
}

interface StartOutlineProps extends OutlinesProps {
  isFaulty: boolean;
}

function StartOutline({ desk, view, isFaulty }: StartOutlineProps) {
  const { x, y } = onBoard(view, desk.shown.value.start);
  const isSelected = desk.selected.value === "start";
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
      data-testid={TEST.worldThing}
      onFocus={() => desk.select("start")}
    >
      <circle class="outline__reach" cx={x} cy={y} r={r} />
      <circle class="outline__line" cx={x} cy={y} r={r} />
    </g>
  );
}

const classes = (kind: string, isSelected: boolean, isFaulty: boolean) =>
  `outline outline--${kind} ${isSelected ? "outline--selected" : ""} ${isFaulty ? "outline--faulty" : ""}`;
