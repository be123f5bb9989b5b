import { useSignal } from "@preact/signals";
import { useRef } from "preact/hooks";
import { exchange } from "../../api/exchange";
import type { Merged } from "../../api/model";
import { asTeacher } from "../../shell/teacher/teacher_session";

export type Merging = ReturnType<typeof useMerging>;

/** Merges files in sequence; `results` has an entry for each. */
export function useMerging(onMerged: () => Promise<void>) {
  const results = useSignal<Merged[]>([]);
  /** Number of times that results were cleared. Results of an earlier merge are not shown. */
  const turn = useRef(0);
  const progress = useSignal<{ n: number; of: number } | null>(null);
  const replace = (merged: Merged) => {
    results.value = results.value.map((one) => (one.path === merged.path ? merged : one));
  };
  const forget = () => {
    turn.current++;
    results.value = [];
  };
  const last = useRef<Promise<void>>(Promise.resolve());
  /** A deletion waits for the files that are still being merged, as it may change their results. */
  const inSequence = (action: () => Promise<void>) => {
    last.current = last.current.then(action, action);
    return last.current;
  };
  const mergeAll = (paths: readonly string[]) =>
    inSequence(async () => {
      forget();
      const mine = turn.current;
      try {
        for (const [index, path] of paths.entries()) {
          progress.value = { n: index + 1, of: paths.length };
          const merged = await asTeacher(() => exchange.merge(path));
          if (merged && mine === turn.current) results.value = [...results.value, merged];
        }
      } finally {
        progress.value = null;
        void onMerged();
      }
    });
  const mergeAgain = async (path: string, retained?: readonly string[]) => {
    const merged = await asTeacher(() => exchange.merge(path, retained));
    if (merged) replace(merged);
  };
  /**
   * Applies the deletion of the other PC, except for retained work. Then merges the files again that
   * had nothing new before: the deletion may have changed this.
   */
  const deleteToo = (deletedBy: string, retained: readonly string[]) =>
    inSequence(async () => {
      await mergeAgain(deletedBy, retained);
      for (const { path, nothing_new, problem } of results.value) {
        if (path !== deletedBy && nothing_new && !problem) await mergeAgain(path);
      }
      void onMerged();
    });
  const declineDeletion = (merged: Merged) => replace({ ...merged, would_delete: null });
  /** Whether the result of a file is shown, with its question. */
  const isAsked = (path: string) =>
    results.value.some((one) => one.path === path && one.problem === null);
  return { results, progress, isAsked, mergeAll, deleteToo, declineDeletion, forget };
}
