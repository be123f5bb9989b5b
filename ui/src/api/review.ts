import type { HistoryRun, LessonReview, VersionDifference } from "../review/model";
import { json } from "./client";
import type { Note } from "./model";

/** Which runs of the history; what is "" does not choose. */
export interface RunFilter {
  classroom: string;
  group: string;
  activity: string;
  day: string;
  outcome: string;
}

interface History {
  runs: HistoryRun[];
  next: string | null;
}

/** What the teacher looks at after class. */
export const reviewApi = {
  lesson: (id: string) => json<LessonReview>("GET", `/api/lessons/${id}/review`),
  /** The table of a lesson, as a spreadsheet opens it. */
  table: async (id: string): Promise<Blob> => {
    const answer = await fetch(`/api/lessons/${id}/review.csv`);
    if (!answer.ok) throw new Error(`no table: ${answer.status}`);
    return answer.blob();
  },
  runs: (filter: RunFilter, before: string | null, limit = 24) => {
    const told = Object.entries({ ...filter, before: before ?? "" }).filter(([, value]) => value);
    return json<History>(
      "GET",
      `/api/runs?${new URLSearchParams([...told, ["limit", String(limit)]])}`,
    );
  },
  difference: (from: string, to: string) =>
    json<VersionDifference>("GET", `/api/versions/${from}/difference?to=${to}`),
  notes: async (run: string) =>
    (await json<{ notes: Note[] }>("GET", `/api/runs/${run}/notes`)).notes,
  writeNote: (run: string, text: string) => json<Note>("POST", `/api/runs/${run}/notes`, { text }),
  rewriteNote: (note: string, text: string) => json<Note>("PATCH", `/api/notes/${note}`, { text }),
  deleteNote: (note: string) => json<unknown>("DELETE", `/api/notes/${note}`),
};
