import { signal } from "@preact/signals";
import { activitiesApi } from "../api/activities";
import { api } from "../api/client";
import type { Group } from "../api/model";
import { Pair, type Side } from "../replay/compare/pair";
import { loadRecordedRun, type RecordedRun } from "../replay/recorded_run";
import type { Playback } from "../run/playback";

/** One run, or two on one clock. */
export interface Presented {
  readonly sides: readonly Side[];
  readonly playback: Playback;
  readonly groups: readonly Group[];
  /** Title of their activity; null without an activity, or if they have different ones. */
  readonly title: string | null;
}

export async function loadPresented(first: string, second: string | null): Promise<Presented> {
  const [one, other, groups] = await Promise.all([
    loadRecordedRun(first),
    second === null ? null : loadRecordedRun(second),
    api.groups(),
  ]);
  const title = await titleOf(one, other);
  if (!other) return { sides: [sideOf(one)], playback: one.playback, groups, title };
  const { sides, playback } = new Pair(one, other);
  playback.seek(0);
  return { sides, playback, groups, title };
}

function sideOf(recordedRun: RecordedRun): Side {
  const { view, playing, pose } = recordedRun.playback;
  return { recordedRun, view, playing, pose, isUntouched: signal(false) };
}

async function titleOf(one: RecordedRun, other: RecordedRun | null): Promise<string | null> {
  const { activity } = one.run;
  if (!activity || (other && other.run.activity !== activity)) return null;
  // an activity of a teacher may have been deleted since
  return activitiesApi.one(activity).then(
    ({ title }) => title,
    () => null,
  );
}
