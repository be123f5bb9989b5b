import { truthsApi } from "../api/real_runs";
import type { Point } from "../run/trail";
import { measuredPieces, sourceOfPath } from "./measured_path";

/** The path of a run that a camera or the robot's localisation saw; undefined if none did, or none answers. */
export async function loadMeasured(run: string): Promise<Point[][] | undefined> {
  const truths = await truthsApi.of(run).catch(() => null);
  const truth = truths && sourceOfPath(truths);
  return truth ? measuredPieces(truth) : undefined;
}
