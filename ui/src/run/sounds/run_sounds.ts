import type { RunView } from "../reducer";
import type { SoundName } from "./sound";

/** Reason of a run that ended because the robot drove against something. */
const COLLISION = "blocked";

/**
 * The sound between two states of a live run, null for none. Each has its visible equal: `start` the running block and
 * the status line, `arrival` and `collision` the sentence about the end of the run.
 */
export function soundBetween(before: RunView, now: RunView): SoundName | null {
  if (before.run !== now.run || before.phase === now.phase) return null;
  if (before.phase === "starting" && now.phase === "running") return "start";
  if (now.phase === "finished" && now.moved) return "arrival";
  return now.phase === "failed" && now.ending?.reason === COLLISION ? "collision" : null;
}
