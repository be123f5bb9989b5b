import { useEffect, useState } from "preact/hooks";
import { usePolling } from "../../kit/usePolling";
import * as robot from "../../run/live";
import type { StudioControl } from "../studio_control";
import { type Box, placeBeside, ringOf, shared } from "./places";
import type { TourStep } from "./steps";

/** Floor, flyout and blocks move without an event, so their positions are polled at this interval. */
const POLL_INTERVAL_MS = 200;

/** Free space below the program, where the pupils drop the block. */
const DROP_SPACE_PX = 56;

interface Targets {
  readonly rings: readonly Box[];
  /** Upper left corner of the balloon. */
  readonly corner: { readonly x: number; readonly y: number };
  /** A drag that an animated hand shows: its start and its displacement, pixels. */
  readonly drag: { x: number; y: number; right: number; down: number } | null;
}

const NOWHERE: Targets = { rings: [], corner: { x: -9999, y: 0 }, drag: null };

/** Current positions of the rings, the balloon and the hand of a step. */
export function useTargets(
  step: TourStep,
  control: StudioControl,
  balloon: { readonly current: HTMLElement | null },
): Targets {
  const [targets, setTargets] = useState(NOWHERE);
  const update = () => {
    const found = targetsOf(step, control, balloon.current);
    setTargets((known) => (JSON.stringify(found) === JSON.stringify(known) ? known : found));
  };
  useEffect(update, [step, control]);
  usePolling(update, { everyMs: POLL_INTERVAL_MS });
  return targets;
}

function targetsOf(step: TourStep, control: StudioControl, balloon: HTMLElement | null): Targets {
  if (!balloon) return NOWHERE;
  const { rings, beside, drag = null } = partsOf(step, control);
  const last = beside ?? rings.at(-1);
  if (!last) return NOWHERE;
  const { width, height } = balloon.getBoundingClientRect();
  const corner = placeBeside({
    size: { width, height },
    beside: last,
    free: [...rings, last],
    window: { width: window.innerWidth, height: window.innerHeight },
  });
  return { rings: rings.map(ringOf), corner, drag };
}

interface Parts {
  rings: Box[];
  beside?: Box | null;
  drag?: Targets["drag"];
}

function partsOf(step: TourStep, control: StudioControl): Parts {
  switch (step) {
    case "hello":
      return { rings: boxes(byId("scene")) };
    case "watch":
      return driving(control);
    case "move":
      return dragParts("move_forward", control);
    case "turn":
      return dragParts("turn", control);
    case "run":
      return { rings: boxes(byId("run")), beside: boxOf(byId("status-line")) };
    case "again":
      return robot.isRunning.peek()
        ? driving(control)
        : { rings: boxes(byId("run")), beside: boxOf(byId("status-line")) };
    case "end":
      // below the verdict of the first run, which it must not cover
      return {
        rings: boxes(byId("saved-mark"), byId("stop")),
        beside: boxOf(byId("status-line")),
      };
  }
}

/** Rings around the running block and the floor. */
function driving({ editor }: StudioControl): Parts {
  return {
    rings: [inEditor(boxOf(editor?.elements.running())), boxOf(byId("scene"))].filter(isThere),
  };
}

/** A drag from the block in the flyout, or its category, to the end of the program. */
function dragParts(type: "move_forward" | "turn", { editor }: StudioControl): Parts {
  const from = boxOf(editor?.elements.offered(type));
  const program = boxOf(editor?.elements.program());
  if (!from || !program) return { rings: [from, program].filter(isThere) };
  const flyout = boxOf(editor?.elements.flyout());
  const x = from.x + Math.min(48, from.width / 2);
  const y = from.y + from.height / 2;
  const drag = { x, y, right: program.x + 48 - x, down: program.y + program.height - 24 - y };
  // in narrow windows the flyout covers the program until the pupils drag a block
  if (flyout && shared(flyout, program)) return { rings: [from], beside: flyout, drag };
  const ring = inEditor(program);
  return {
    rings: [from, ring].filter(isThere),
    beside: ring && { ...ring, height: ring.height + DROP_SPACE_PX },
    drag,
  };
}

const byId = (testId: string) => document.querySelector(`[data-testid="${testId}"]`);

const boxes = (...elements: (Element | null)[]): Box[] => elements.map(boxOf).filter(isThere);

const isThere = (box: Box | null): box is Box => box !== null;

/** The part of a block that is visible in the editor. */
function inEditor(block: Box | null): Box | null {
  const pane = boxOf(byId("editor"));
  return block && pane && shared(block, pane);
}

/** The box of an element in whole pixels: drawings of blocks move by fractions of a pixel. */
function boxOf(element: Element | null | undefined): Box | null {
  if (!element) return null;
  const { x, y, width, height } = element.getBoundingClientRect();
  if (width === 0) return null;
  return {
    x: Math.round(x),
    y: Math.round(y),
    width: Math.round(width),
    height: Math.round(height),
  };
}
