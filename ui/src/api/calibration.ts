import { del, get, of, post } from "./client";

/** Requests about robots of the simulator with the errors of a real one. */
export const calibrationApi = {
  robots: async () => (await get("/api/calibrated-robots")).robots,
  realRuns: async () => (await get("/api/real-runs")).runs,
  /** What runs tell about a real robot; stores nothing. */
  calibrate: (runs: string[]) => post("/api/calibrations", { body: { runs } }),
  save: (runs: string[], title: string) =>
    post("/api/calibrated-robots", { body: { runs, title } }),
  remove: (id: string) => del("/api/calibrated-robots/{id}", of(id)),
  restore: (id: string) => post("/api/calibrated-robots/{id}/take-back", of(id)),
};
