import type { XY } from "../frames";

type Ctx = CanvasRenderingContext2D;

/** Duration of the celebration of a solved mission, in ms. */
export const CELEBRATION_MS = 2000;

const PIECES = 84;
/** Initial speeds and the acceleration downwards, in pixels and seconds. */
const MIN_SPEED = 90;
const MAX_SPEED = 330;
const GRAVITY = 190;
const FADE_MS = 500;
const GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));
const LEAVES = 16;

/** A piece of paper, in pixels of the canvas; its turn in radians. */
export interface Piece {
  readonly x: number;
  readonly y: number;
  readonly turn: number;
  readonly colour: string;
}

/** The pieces of paper that flew up from `origin`, `ms` ago. The same for each celebration. */
export function confetti(origin: XY, ms: number, colours: readonly string[]): Piece[] {
  const s = ms / 1000;
  return Array.from({ length: PIECES }, (_, index) => {
    const angle = index * GOLDEN_ANGLE;
    const part = ((index * 37) % PIECES) / PIECES;
    const speed = MIN_SPEED + (MAX_SPEED - MIN_SPEED) * part;
    const drag = (1 - Math.exp(-1.6 * s)) / 1.6;
    return {
      x: origin.x + speed * Math.cos(angle) * drag,
      y: origin.y + (speed * Math.sin(angle) - 110) * drag + (GRAVITY * s * s) / 2,
      turn: angle + (3 + 5 * part) * s,
      colour: colours[index % colours.length] ?? "",
    };
  });
}

/** Draws the pieces of paper of a moment; in the last half second they fade. */
export function drawConfetti(
  ctx: Ctx,
  origin: XY,
  ms: number,
  colours: readonly string[],
  edge: string,
): void {
  ctx.save();
  ctx.globalAlpha = Math.max(0, Math.min(1, (CELEBRATION_MS - ms) / FADE_MS));
  ctx.strokeStyle = edge;
  ctx.lineWidth = 1;
  for (const { x, y, turn, colour } of confetti(origin, ms, colours)) {
    ctx.save();
    ctx.translate(x, y);
    ctx.rotate(turn);
    ctx.scale(1, Math.max(0.35, Math.abs(Math.cos(1.7 * turn))));
    ctx.fillStyle = colour;
    ctx.fillRect(-5, -4, 10, 8);
    ctx.strokeRect(-5, -4, 10, 8);
    ctx.restore();
  }
  ctx.restore();
}

/** Draws a still wreath around the robot, for people who want no motion. */
export function drawWreath(
  ctx: Ctx,
  origin: XY,
  reach: number,
  colours: readonly string[],
  edge: string,
): void {
  const radius = reach + 16;
  ctx.save();
  ctx.translate(origin.x, origin.y);
  ctx.strokeStyle = edge;
  ctx.lineWidth = 2;
  for (let index = 0; index < LEAVES; index++) {
    // the wreath is open at the top
    const angle = -Math.PI / 2 + ((index + 1) * 2 * Math.PI) / (LEAVES + 1);
    ctx.save();
    ctx.rotate(angle);
    ctx.translate(radius, 0);
    ctx.rotate(index < LEAVES / 2 ? -0.5 : 0.5);
    ctx.beginPath();
    ctx.ellipse(0, 0, 7, 14, 0, 0, 2 * Math.PI);
    ctx.fillStyle = colours[index % colours.length] ?? "";
    ctx.fill();
    ctx.stroke();
    ctx.restore();
  }
  ctx.restore();
}
