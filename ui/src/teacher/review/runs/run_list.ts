import { signal } from "@preact/signals";
import { classesApi, NO_CLASS } from "../../../api/classes";
import type { HistoryRun, Lesson } from "../../../api/model";
import { type RunFilter, reviewApi } from "../../../api/review";
import { loadSchool, type School } from "../../school";
import { useTeacherLoaded } from "../../useTeacherLoaded";

export const NO_FILTER: RunFilter = {
  classroom: "",
  group: "",
  lesson: "",
  activity: "",
  world: "",
  day: "",
  outcome: "",
};

/** Filter and selection, stored until the page is closed, for the return from a replay. */
export const filter = signal<RunFilter>(NO_FILTER);
export const chosen = signal<readonly HistoryRun[]>([]);

/** View state of the list: scroll position, number of shown runs, and their filter. */
export const left = { top: 0, runs: 0, filter: NO_FILTER };

export interface RunPage {
  runs: readonly HistoryRun[];
  /** The cursor of the next page; null at the end. */
  next: string | null;
}

/** The runs that match the filter, newest first; `older` loads another page. */
export function useRunList() {
  const requested = filter.value;
  const list = useTeacherLoaded(requested, async () => {
    const page = await loadRuns(requested, left.filter === requested ? left.runs : 0);
    Object.assign(left, { filter: requested, runs: page.runs.length });
    return page;
  });
  const older = () => {
    left.runs += 1;
    return list.reload();
  };
  return { list, older };
}

/** Loads pages until there are at least `minRuns` runs. */
async function loadRuns(requested: RunFilter, minRuns: number): Promise<RunPage> {
  let { runs, next } = await reviewApi.runs(requested, null);
  while (next && runs.length < minRuns) {
    const page = await reviewApi.runs(requested, next);
    runs = [...runs, ...page.runs];
    next = page.next;
  }
  return { runs, next };
}

/** Options of the filters. */
export type FilterChoices = Awaited<ReturnType<typeof loadFilterChoices>>;

export async function loadFilterChoices() {
  const [school, activities] = await Promise.all([loadSchool(), classesApi.activities()]);
  return { ...school, activities, lessons: await loadLessons(school) };
}

/** The lessons of all classes, newest first, including joined lessons. */
async function loadLessons({ classes }: School): Promise<Lesson[]> {
  const places = [...classes.map(({ id }) => id), NO_CLASS];
  const lessons = await Promise.all(places.map((place) => classesApi.lessons(place)));
  return lessons.flat().sort((one, other) => other.opened_at.localeCompare(one.opened_at));
}
