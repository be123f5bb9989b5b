import type { Start, World } from "../../api/model";
import { listen } from "../../kit/listen";
import type { XY } from "../frames";
import type { SceneRenderer } from "../renderer";
import { POINTS_OF, snapped } from "./measure";
import { directionOf, facing, handleOf, isStartKey, movedTo, nudged } from "./start_pose";
import type { SceneTools } from "./tools";

/** A robot that can be dragged. */
export interface Grip {
  readonly world: World | null;
  /** The robot's pose; null while a run moves the robot. */
  readonly here: Start | null;
  /** Whether the robot is at its start, and so has a handle that turns it. */
  readonly isAtStart: boolean;
  put(start: Start): void;
}

interface Floor {
  readonly element: HTMLCanvasElement;
  readonly scene: SceneRenderer;
  readonly tools: SceneTools;
  grip(): Grip | null;
  /** Called with the place of a click that neither drags nor measures, world frame. */
  onClick?(place: XY): void;
  /** Points that measurements snap to, world frame. */
  snapPoints(): XY[];
}

/** Touch radius, and maximum movement of a click; pixels. */
const REACH_PX = 22;
const CLICK_PX = 6;
const ROBOT_M = 0.24;

type Mode = "pan" | "move" | "turn" | "measure";

/** Handles pointer and keys on the floor: measuring, dragging the robot, panning. Returns the unsubscribe function. */
export function listenToPointer(floor: Floor): () => void {
  const { element, scene, tools } = floor;
  let mode: Mode | null = null;
  let last: XY = { x: 0, y: 0 };
  let far = 0;
  let dragStart: Start | null = null;
  /** Whether the current press set the first point. */
  let fresh = false;

  const placeOf = (event: PointerEvent): XY => {
    const box = element.getBoundingClientRect();
    return scene.floorAt({ x: event.clientX - box.left, y: event.clientY - box.top });
  };
  const snap = (event: PointerEvent) =>
    snapped(placeOf(event), floor.snapPoints(), REACH_PX * 0.75 * scene.pixel);

  const down = (event: PointerEvent) => {
    if (event.button !== 0) return;
    element.setPointerCapture(event.pointerId);
    last = { x: event.clientX, y: event.clientY };
    far = 0;
    mode = tools.tool.peek() ? "measure" : holdAt(placeOf(event), floor);
    if (mode === "measure") fresh = beginMeasure(tools, snap(event));
    if (mode !== "move" && mode !== "turn") return;
    dragStart = floor.grip()?.here ?? null;
    scene.hold(true);
  };
  const move = (event: PointerEvent) => {
    const [dx, dy] = [event.clientX - last.x, event.clientY - last.y];
    far = Math.max(far, Math.hypot(dx, dy));
    if (mode === null) hover(event);
    else if (mode === "measure") tools.draft.value = snap(event);
    else if (mode === "pan") {
      scene.pan(dx, dy);
      last = { x: event.clientX, y: event.clientY };
    } else if (far >= CLICK_PX) drag(event, mode);
  };
  const drag = (event: PointerEvent, how: "move" | "turn") => {
    const grip = floor.grip();
    if (!grip || !dragStart) return;
    const place = placeOf(event);
    const free = event.shiftKey;
    grip.put(
      how === "turn" ? facing(dragStart, place, free) : movedTo(dragStart, place, grip.world, free),
    );
  };
  const hover = (event: PointerEvent) => {
    const { value: tool } = tools.tool;
    if (tool) {
      if (tools.points.peek().length > 0 && !tools.isDone.peek()) tools.draft.value = snap(event);
      element.dataset.grip = "measure";
    } else element.dataset.grip = holdAt(placeOf(event), floor);
  };
  const up = (event: PointerEvent) => {
    if (mode === "measure" && (!fresh || far >= CLICK_PX)) endMeasure(tools, snap(event));
    if (mode === "move" || mode === "turn") scene.hold(false);
    if (mode === "pan" && far < CLICK_PX && event.type === "pointerup") {
      floor.onClick?.(placeOf(event));
    }
    mode = null;
  };
  const wheel = (event: WheelEvent) => {
    event.preventDefault();
    scene.zoom(Math.exp(-event.deltaY / 500));
  };
  const key = (event: KeyboardEvent) => {
    if (tools.tool.peek() ? measureKey(event, floor) : startKey(event, floor)) {
      event.preventDefault();
      event.stopPropagation();
    }
  };
  const listeners = {
    pointerdown: down,
    pointermove: move,
    pointerup: up,
    pointercancel: up,
    wheel,
    keydown: key,
  };
  return listen(element, listeners, { passive: false });
}

/** The kind of drag that a press at a point of the floor starts. */
function holdAt(place: XY, { scene, grip }: Floor): Exclude<Mode, "measure"> {
  const robot = grip();
  const { here } = robot ?? {};
  if (!robot || !here) return "pan";
  const reach = REACH_PX * scene.pixel;
  const near = (spot: XY, within: number) =>
    Math.hypot(spot.x - place.x, spot.y - place.y) < within;
  if (near({ x: here.x_m, y: here.y_m }, ROBOT_M)) return "move";
  if (robot.isAtStart && near(handleOf(here), reach)) return "turn";
  return near({ x: here.x_m, y: here.y_m }, reach) ? "move" : "pan";
}

/** Sets the first point at a press; a release sets each further point. Returns true for the first. */
function beginMeasure(tools: SceneTools, place: XY): boolean {
  const first = tools.points.peek().length === 0 || tools.isDone.peek();
  if (first) tools.set(place);
  else tools.draft.value = place;
  return first;
}

function endMeasure(tools: SceneTools, place: XY): void {
  const { value: tool } = tools.tool;
  if (tool && tools.points.peek().length < POINTS_OF[tool]) tools.set(place);
}

/** Arrow keys move the next point, Enter sets it. */
function measureKey(event: KeyboardEvent, { scene, tools }: Floor): boolean {
  const now = tools.draft.peek() ?? tools.points.peek().at(-1) ?? scene.robotAt;
  if (event.key === "Enter" || event.key === " ") {
    tools.set(now);
    return true;
  }
  const direction = directionOf(event.key);
  if (!direction) return false;
  const step = event.shiftKey ? 0.01 : 0.1;
  tools.draft.value = { x: now.x + direction[0] * step, y: now.y + direction[1] * step };
  return true;
}

/** Arrow keys move the start; comma and period turn it. */
function startKey({ key, shiftKey, ctrlKey }: KeyboardEvent, { grip }: Floor): boolean {
  const robot = grip();
  if (!robot?.here || ctrlKey || !isStartKey(key)) return false;
  robot.put(nudged(robot.here, key, robot.world, shiftKey));
  return true;
}
