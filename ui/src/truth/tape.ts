import type { BelievedPose, TruePose } from "../api/model";
import type { Language } from "../i18n";
import { formatNumber, headingDegrees } from "../i18n/format";
import { numberIn } from "../kit/NumberField";

/** Longest distance that the form accepts, cm; the server also compares with the room. */
export const MAX_CM = 5000;

/** Degrees by which the buttons turn the drawing of the robot. */
export const TURN_DEG = 15;

const SIGMA_M = 0.01;
/** One sigma of a heading that was measured in degrees. */
const SIGMA_DEG = 2;
/** One sigma of a heading that was compared with drawings `TURN_DEG` apart. */
const SIGMA_BY_DRAWING_DEG = TURN_DEG / Math.sqrt(12);

const RADIANS = Math.PI / 180;

/** A distance as typed, and its side of the start mark: behind it or to its right are negative. */
export interface Distance {
  readonly text: string;
  readonly isNegative: boolean;
}

/** What was measured with a tape, as the form has it. */
export interface TapeEntry {
  readonly forward: Distance;
  readonly sideways: Distance;
  readonly headingDeg: number;
  /** Whether the heading was typed, not chosen by its drawing. */
  readonly isHeadingTyped: boolean;
}

/** The typed distance in cm, never negative; null if it is none. */
export function centimetres({ text }: Distance): number | null {
  const cm = numberIn(text);
  return cm !== null && cm >= 0 && cm <= MAX_CM ? cm : null;
}

/** Whether something was typed that is no distance. */
export const isWrong = (distance: Distance) =>
  distance.text.trim() !== "" && centimetres(distance) === null;

/** The measured pose after the run; null until both distances are typed. */
export function poseOf(entry: TapeEntry): TruePose | null {
  const [x_m, y_m] = [metres(entry.forward), metres(entry.sideways)];
  if (x_m === null || y_m === null) return null;
  return {
    tick: null,
    x_m,
    y_m,
    heading_rad: entry.headingDeg * RADIANS,
    sigma_m: SIGMA_M,
    sigma_rad: (entry.isHeadingTyped ? SIGMA_DEG : SIGMA_BY_DRAWING_DEG) * RADIANS,
  };
}

function metres(distance: Distance): number | null {
  const cm = centimetres(distance);
  if (cm === null) return null;
  return (distance.isNegative ? -cm : cm) / 100;
}

/** What the form shows first: what was measured before, else nothing and the sides and the heading as believed. */
export function entryOf(
  measured: TruePose | null,
  believed: BelievedPose | null,
  language: Language,
): TapeEntry {
  const from = measured ?? believed ?? { x_m: 0, y_m: 0, heading_rad: 0 };
  const distance = (value: number): Distance => ({
    text: measured ? formatNumber(Math.round(Math.abs(value) * 1000) / 10, language) : "",
    isNegative: Math.round(value * 100) < 0,
  });
  const heading = headingDegrees(from.heading_rad);
  return {
    forward: distance(from.x_m),
    sideways: distance(from.y_m),
    headingDeg: measured ? Math.round(heading) : turned(Math.round(heading / TURN_DEG), 0),
    isHeadingTyped: false,
  };
}

/** The heading after turning by steps to the left, in (-180, 180] degrees, on a whole step. */
export function turned(steps: number, headingDeg: number): number {
  const onStep = (Math.round(headingDeg / TURN_DEG) + steps) * TURN_DEG;
  return headingDegrees(onStep * RADIANS);
}
