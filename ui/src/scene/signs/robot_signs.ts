import type { Colours } from "../colours";
import type { Livery } from "../livery/livery";
import { liveryPaint } from "../livery/livery";
import { paintOf } from "../paints";
import { drawWaves, WAVES_PX } from "./beep_view";
import { drawBubble, drawName, drawPlate, type NameSide, type RobotPlace } from "./bubble_view";
import { CELEBRATION_MS, drawConfetti, drawWreath } from "./celebration_view";

type Ctx = CanvasRenderingContext2D;

/** Duration in which a sign grows from the robot, in ms. */
const GROWING_MS = 160;
/** Gap between the robot's circle and a sign, in metres; minimum distance from the robot's centre, in pixels. */
const FREE_M = 0.08;
const FREE_PX = 16;

interface ShownText {
  readonly text: string;
  /** Time at which the sign appeared, of the screen's clock. */
  readonly since: number;
}

/** What the signs need to know of the robot in a frame. */
export interface RobotFrame extends Omit<RobotPlace, "reach"> {
  readonly radius_m: number;
  /** Pixels of a metre. */
  readonly scale: number;
  /** Where the robot's name is. */
  readonly nameSide: NameSide;
  readonly livery: Livery | null;
  /** Whether no run is live: the robot's name is shown. */
  readonly atRest: boolean;
}

/** The radius around the robot's centre that stays free of signs, in pixels. */
export const reachOf = (radius_m: number, scale: number): number =>
  Math.max(FREE_PX, (radius_m + FREE_M) * scale);

/** The signs around the robot: what it says, its beep, its name, and the celebration of a solved mission. */
export class RobotSigns {
  private beep: ShownText | null = null;
  private text: ShownText | null = null;
  private celebratedSince: number | null = null;

  /** Sets the text at the robot while it beeps; "" while it does not. Only the first of consecutive beeps grows. */
  setBeep(text: string): void {
    this.beep = text ? { text, since: this.beep?.since ?? performance.now() } : null;
  }

  /** Sets what the robot says; "" for nothing. */
  setText(text: string): void {
    if (text === (this.text?.text ?? "")) return;
    this.text = text ? { text, since: performance.now() } : null;
  }

  celebrate(): void {
    this.celebratedSince = performance.now();
  }

  /** Draws all signs; returns whether they move. */
  draw(ctx: Ctx, frame: RobotFrame, now: number, still: boolean, colours: Colours): boolean {
    const { beep, text } = this;
    const reach = reachOf(frame.radius_m, frame.scale);
    const grown = (sign: ShownText) =>
      still ? 1 : Math.min(1, Math.max(0, now - sign.since) / GROWING_MS);
    const isCelebrating = this.drawCelebration(ctx, frame, reach, now, still, colours);
    if (beep) drawWaves(ctx, frame.at, reach, grown(beep), colours);
    const place = { ...frame, reach: beep ? reach + WAVES_PX : reach };
    if (text) drawBubble(ctx, text.text, place, grown(text), colours);
    else if (beep) drawPlate(ctx, beep.text, place, colours);
    else if (frame.atRest && frame.livery?.name && !isCelebrating)
      drawName(ctx, frame.livery.name, place, frame.nameSide, colours);
    return isCelebrating;
  }

  private drawCelebration(
    ctx: Ctx,
    { at, livery }: RobotFrame,
    reach: number,
    now: number,
    still: boolean,
    colours: Colours,
  ): boolean {
    if (this.celebratedSince === null) return false;
    const ms = Math.max(0, now - this.celebratedSince);
    if (ms >= CELEBRATION_MS) {
      this.celebratedSince = null;
      return false;
    }
    const { body, pattern } = liveryPaint(livery, colours);
    const all = [body, pattern?.colour ?? colours.tile, paintOf("yellow"), colours.path];
    if (still) drawWreath(ctx, at, reach, all, colours.ink);
    else drawConfetti(ctx, at, ms, all, colours.ink);
    return true;
  }
}
