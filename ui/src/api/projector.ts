import { del, put } from "./client";

/** What a projector shows: one or two runs, or a program. */
export type Presented = { readonly runs: string[] } | { readonly program: string };

/** Requests to the second window, on a projector. */
export const projectorApi = {
  /** Whether a window on a second screen shows it: there may be none. */
  present: async (body: Presented) => (await put("/api/projector", { body })).has_window,
  end: () => del("/api/projector", {}),
};
