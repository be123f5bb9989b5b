import { useEffect, useState } from "preact/hooks";
import { usePolling } from "../../kit/usePolling";
import * as robot from "../../run/live";
import type { StudioControl } from "../studio_control";
import { type Box, placeBeside, ringOf, shared } from "./places";
import type { Step } from "./steps";

/** Things of the page move without telling: floor, palette and blocks are looked at this often. */
const POLL_INTERVAL_MS = 200;

/** Left free below the program, where the block is dropped. */
const DROP_SPACE_PX = 56;

interface Targets {
  readonly rings: readonly Box[];
  /** Of the balloon. */
  readonly corner: { readonly x: number; readonly y: number };
  /** A drag to show by a hand: its beginning and its way. */
  readonly drag: { x: number; y: number; right: number; down: number } | null;
}

const NOWHERE: Targets = { rings: [], corner: { x: -9999, y: 0 }, drag: null };

/** Where rings, balloon and hand of a step stand at the moment. */
export function useTargets(
  step: Step,
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

function targetsOf(step: Step, control: StudioControl, balloon: HTMLElement | null): Targets {
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

function partsOf(step: Step, control: StudioControl): Parts {
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
      return { rings: boxes(byId("saved-mark"), byId("stop")) };
  }
}

/** The block that runs, and the floor. */
function driving({ editor }: StudioControl): Parts {
  return {
    rings: [inEditor(boxOf(editor?.elements.running())), boxOf(byId("scene"))].filter(isThere),
  };
}

/** From the block in the palette, or its category, to the end of the program. */
function dragParts(type: "move_forward" | "turn", { editor }: StudioControl): Parts {
  const from = boxOf(editor?.elements.offered(type));
  const program = boxOf(editor?.elements.program());
  if (!from || !program) return { rings: [from, program].filter(isThere) };
  const flyout = boxOf(editor?.elements.flyout());
  const x = from.x + Math.min(48, from.width / 2);
  const y = from.y + from.height / 2;
  const drag = { x, y, right: program.x + 48 - x, down: program.y + program.height - 24 - y };
  // in narrow windows the palette lies over the program, until a block is taken
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

/** Of a block the part that the editor shows. */
function inEditor(block: Box | null): Box | null {
  const pane = boxOf(byId("editor"));
  return block && pane && shared(block, pane);
}

/** Whole pixels, because drawings of blocks move by fractions. */
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
