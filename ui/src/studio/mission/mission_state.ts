import type { Activity, CheckProgress, JudgedEvent } from "../../api/model";
import { checksOf, verdictOf } from "../../run/judgement";
import * as robot from "../../run/live";
import { checkStatus, judged } from "../../shell/session";
import type { JudgedCase } from "../ghost";
import type { StudioControl } from "../studio_control";

export type Mark = CheckProgress["state"];

/** A mission during and after a run of its program. */
export interface MissionState {
  readonly verdict: JudgedEvent | null;
  readonly checks: readonly CheckProgress[];
  /** The checks, then the further cases that the judge has run. */
  readonly marks: readonly Mark[];
  /** Whether any run has passed. */
  readonly isDone: boolean;
  /** Whether success is what there is to say: the last run has passed, or none was made since the program was opened. */
  readonly isSuccess: boolean;
}

export function missionState(control: StudioControl, mission: Activity): MissionState {
  const run = control.mine.value ? robot.live.value.run : null;
  const verdict = verdictOf(run, judged.value);
  const checks = checksOf(mission, verdict?.not_judged ? null : run, checkStatus.value);
  const hasPassed = verdict?.passed === true;
  const isDone = hasPassed || control.open.passed.value.has(mission.name);
  return {
    verdict,
    checks,
    marks: marksOf(checks, verdict),
    isDone,
    isSuccess: hasPassed || (isDone && run === null),
  };
}

/** A mark of each check and of each case that the group did not watch. */
export function marksOf(
  checks: readonly Pick<CheckProgress, "state">[],
  verdict: { readonly cases: readonly Pick<JudgedCase, "seen" | "passed">[] } | null,
): Mark[] {
  const cases = (verdict?.cases ?? []).filter(({ seen }) => !seen);
  return [
    ...checks.map(({ state }) => state),
    ...cases.map(({ passed }): Mark => (passed ? "met" : "broken")),
  ];
}
