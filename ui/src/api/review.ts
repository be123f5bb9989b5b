import { asFile, del, file, get, of, patch, post } from "./client";

/** Filter of the run history; "" stands for no condition. */
export interface RunFilter {
  classroom: string;
  group: string;
  lesson: string;
  activity: string;
  world: string;
  day: string;
  outcome: string;
}

/** Requests for the teacher's review after class. */
export const reviewApi = {
  lesson: (id: string) => get("/api/lessons/{id}/review", of(id)),
  /** The table of a lesson as CSV for a spreadsheet. */
  table: (id: string) => file(get("/api/lessons/{id}/review.csv", asFile(id))),
  runs: (filter: RunFilter, before: string | null, limit = 24) => {
    const entries = Object.entries({ ...filter, before }).filter(([, value]) => value);
    return get("/api/runs", { params: { query: { ...Object.fromEntries(entries), limit } } });
  },
  difference: (id: string, to: string) =>
    get("/api/versions/{id}/difference", { params: { path: { id }, query: { to } } }),
  /** Makes a run count although this PC cannot repeat it. */
  accept: (run: string) => post("/api/runs/{id}/accept", of(run)),
  notes: async (run: string) => (await get("/api/runs/{id}/notes", of(run))).notes,
  writeNote: (run: string, text: string) =>
    post("/api/runs/{id}/notes", { ...of(run), body: { text } }),
  rewriteNote: (note: string, text: string) =>
    patch("/api/notes/{id}", { ...of(note), body: { text } }),
  deleteNote: (note: string) => del("/api/notes/{id}", of(note)),
};
