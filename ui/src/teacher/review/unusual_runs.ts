import { signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { UnusualRun } from "../../api/model";
import { predictionsApi } from "../../api/real_runs";

/** Runs on real robots that are out of the ordinary for their robot, by id, as in the last answer. */
export const unusualRuns = signal<ReadonlyMap<string, UnusualRun>>(new Map());

/** Loads them beside a list of runs; without an answer the list says nothing about them. */
export function useUnusualRuns(): void {
  useEffect(() => {
    predictionsApi.unusual().then(
      (runs) => {
        unusualRuns.value = new Map(runs.map((run) => [run.run, run]));
      },
      () => {},
    );
  }, []);
}
