import type { Truth, TruthList } from "../api/model";
import type { Point } from "../run/trail";

/** Between poses that are farther apart, in steps of 1/30 s, the source saw nothing. */
const GAP_TICKS = 15;
/** The sources that see a robot while it drives, the better one first. */
const DURING_RUN = ["camera", "localisation"] as const;

/** The source whose path is compared and drawn; undefined without one. */
export const sourceOfPath = ({ truths }: TruthList): Truth | undefined =>
  DURING_RUN.map((name) => truths.find(({ source }) => source === name)).find(
    (truth) => truth && duringRun(truth).length > 1,
  );

/** The path that a source saw, in pieces between which it saw nothing. */
export function measuredPieces(truth: Truth): Point[][] {
  const pieces: Point[][] = [];
  let last = Number.NEGATIVE_INFINITY;
  for (const { tick, x_m, y_m } of duringRun(truth)) {
    if (tick - last > GAP_TICKS) pieces.push([]);
    pieces.at(-1)?.push([x_m, y_m]);
    last = tick;
  }
  return pieces;
}

const duringRun = ({ poses }: Truth) =>
  poses.flatMap(({ tick, x_m, y_m }) => (tick === null ? [] : [{ tick, x_m, y_m }]));
