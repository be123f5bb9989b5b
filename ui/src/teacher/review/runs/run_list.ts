import { signal } from "@preact/signals";
import { classesApi } from "../../../api/classes";
import type { HistoryRun } from "../../../api/model";
import { type RunFilter, reviewApi } from "../../../api/review";
import { loadSchool } from "../../school";
import { useTeacherLoaded } from "../../useTeacherLoaded";

export const NO_FILTER: RunFilter = {
  classroom: "",
  group: "",
  activity: "",
  day: "",
  outcome: "",
};

/** Filter and choice are kept until the page is closed, for the way back from a replay. */
export const filter = signal<RunFilter>(NO_FILTER);
export const chosen = signal<readonly HistoryRun[]>([]);

/** How the list was left: where it was scrolled to, and how many runs of which filter it showed. */
export const left = { top: 0, runs: 0, filter: NO_FILTER };

export interface RunPage {
  runs: readonly HistoryRun[];
  /** The cursor of the next page; null at the end. */
  next: string | null;
}

/** The runs that match the filter, newest first; `older` adds a page of them. */
export function useRunList() {
  const wanted = filter.value;
  const list = useTeacherLoaded(wanted, async () => {
    const page = await loadRuns(wanted, left.filter === wanted ? left.runs : 0);
    Object.assign(left, { filter: wanted, runs: page.runs.length });
    return page;
  });
  const older = () => {
    left.runs += 1;
    return list.again();
  };
  return { list, older };
}

/** As many pages as it takes to show at least so many runs. */
async function loadRuns(wanted: RunFilter, least: number): Promise<RunPage> {
  let { runs, next } = await reviewApi.runs(wanted, null);
  while (next && runs.length < least) {
    const page = await reviewApi.runs(wanted, next);
    runs = [...runs, ...page.runs];
    next = page.next;
  }
  return { runs, next };
}

/** What can be chosen in the filters. */
export type FilterChoices = Awaited<ReturnType<typeof loadFilterChoices>>;

export async function loadFilterChoices() {
  const [school, activities] = await Promise.all([loadSchool(), classesApi.activities()]);
  return { ...school, activities };
}
