import { get, of } from "./client";

/** Requests for the predictions of runs on real robots. */
export const predictionsApi = {
  of: (run: string) => get("/api/runs/{id}/prediction", of(run)),
  /** Runs out of the ordinary for their robot. */
  unusual: async () => (await get("/api/unusual-runs")).runs,
};
