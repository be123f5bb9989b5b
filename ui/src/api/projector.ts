import { del, put } from "./client";

/** Requests to the second window, which shows runs on a projector. */
export const projectorApi = {
  /** Whether a window on a second screen shows the runs: there may be none. */
  present: async (runs: string[]) => (await put("/api/projector", { body: { runs } })).has_window,
  end: () => del("/api/projector", {}),
};
