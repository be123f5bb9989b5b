import { computed, signal } from "@preact/signals";
import type { TruthSourceChangedEvent } from "../../api/model";

type Source = TruthSourceChangedEvent["source"];

/** A source of truth in the last run that it followed. */
export interface FollowedRun {
  readonly run: string;
  readonly state: TruthSourceChangedEvent["state"];
  /** The problem now, with its remedy; "" without one. */
  readonly problem: string;
  /** All problems of the run so far, each once, without remedies. */
  readonly problems: readonly string[];
}

/** The sources that follow robots beside their odometry. */
export const truthSources = signal<Readonly<Partial<Record<Source, FollowedRun>>>>({});

/** Number of truths that the server has recorded at the ends of runs. */
export const recordedTruths = signal(0);

/** The sources of a run, in the order of their first event. */
export const followedRun = (run: string | null) =>
  computed(() =>
    Object.entries(truthSources.value).flatMap(([source, one]) =>
      one.run === run ? [{ ...one, source: source as Source }] : [],
    ),
  );

export function receiveTruthSource(event: TruthSourceChangedEvent): void {
  const { run, source, state, message, remedy } = event;
  const before = truthSources.peek()[source];
  const known = before?.run === run ? before.problems : [];
  const isNew = message !== "" && !known.includes(message);
  truthSources.value = {
    ...truthSources.peek(),
    [source]: {
      run,
      state,
      problem: `${message} ${remedy}`.trim(),
      problems: isNew ? [...known, message] : known,
    },
  };
  if (state === "recorded") recordedTruths.value += 1;
}
