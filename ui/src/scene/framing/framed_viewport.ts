import type { World } from "../../api/model";
import type { RunView } from "../../run/reducer";
import type { XY } from "../frames";
import { contentBounds, type Paths, wholeRoom } from "./content_bounds";
import {
  approach,
  clampScale,
  marginsOf,
  type Size,
  toFloor,
  type Viewport,
  viewportFor,
} from "./viewport";

/**
 * Content of the viewport: `subject` (the bounds of `content_bounds`), the whole room, the view set
 * by the user, or the robot, which it follows.
 */
export type Framing = "subject" | "room" | "manual" | "robot";

/** What the viewport is computed from. */
export interface Framed {
  readonly world: World | null;
  /** The state whose whole path the viewport shows. */
  readonly whole: RunView;
  readonly companion: { readonly world: World | null; readonly view: RunView } | null;
  readonly bundle: Paths | null;
  readonly size: Size;
  readonly magnification: number;
  readonly hasControls: boolean;
}

/** The viewport of a floor: it moves towards its target, which follows the framing or the user. */
export class FramedViewport {
  private viewport: Viewport | null = null;
  private target: Viewport = { x: 0, y: 0, scale: 60 };
  private framing: Framing = "subject";
  private isStale = false;
  /** Whether the user drags something: the viewport does not move meanwhile. */
  private held = false;

  constructor(
    private readonly framed: () => Framed,
    private readonly onFraming: (framing: Framing) => void,
  ) {}

  /** The viewport of the last frame. */
  get current(): Viewport {
    return this.viewport ?? this.target;
  }

  /** The content changed: the target is computed at the next frame, because many changes may arrive before it. */
  invalidate(): void {
    this.isStale = true;
  }

  /** Goes to the target at once, without moving towards it. */
  jump(): void {
    this.viewport = null;
    this.aim();
  }

  /** Shows the subject of another room. */
  reset(): void {
    this.choose("subject");
    this.jump();
  }

  hold(held: boolean): void {
    this.held = held;
    this.invalidate();
  }

  follow(isOn: boolean): void {
    if (isOn) this.choose("robot");
    else if (this.framing === "robot") this.choose("manual");
    this.aim();
  }

  /** Shows the subject; if the viewport already shows it, shows the whole room. */
  fit(): void {
    this.choose(this.framing === "subject" ? "room" : "subject");
    this.aim();
  }

  zoom(factor: number): void {
    if (this.framing !== "robot") this.choose("manual");
    this.target = { ...this.target, scale: clampScale(this.target.scale * factor) };
  }

  pan(dx: number, dy: number): void {
    this.choose("manual");
    const { x, y, scale } = this.target;
    const m = 1 / (scale * this.framed().magnification);
    this.target = { x: x - dx * m, y: y + dy * m, scale };
    this.viewport = { ...this.target };
  }

  /** Converts a point of the canvas to the world frame. */
  floorAt({ x, y }: XY): XY {
    const { magnification, size } = this.framed();
    return toFloor(this.current, size, { x: x / magnification, y: y / magnification });
  }

  /** Moves one step; returns whether the viewport has not arrived. `robot` is the robot's position in the world frame. */
  advance(robot: XY, elapsedMs: number, still: boolean): boolean {
    if (this.isStale) this.aim();
    if (this.framing === "robot" && !this.held) {
      this.target = { ...robot, scale: this.target.scale };
    }
    this.viewport ??= { ...this.target };
    return approach(this.viewport, this.target, elapsedMs, still);
  }

  private choose(framing: Framing): void {
    if (framing === this.framing) return;
    this.framing = framing;
    this.onFraming(framing);
  }

  private aim(): void {
    this.isStale = false;
    if (this.held) return;
    const { world, whole, companion, bundle, size, magnification, hasControls } = this.framed();
    const edge = marginsOf(size, magnification, hasControls, whole.capture !== null);
    if (this.framing === "subject")
      this.target = viewportFor(contentBounds(world, whole, companion, bundle), size, edge);
    if (this.framing === "room") this.target = viewportFor(wholeRoom(world), size, edge);
  }
}
