import { del, get, of, post, put } from "./client";
import type { OverheadMeasures, TruePose, Truth } from "./model";

/** Requests about where real robots truly were in their runs. */
export const truthsApi = {
  of: (run: string) => get("/api/runs/{id}/truths", of(run)),
  /** Replaces what a source says; no poses take it back. */
  put: (run: string, source: Truth["source"], poses: TruePose[]) =>
    put("/api/runs/{id}/truths/{source}", {
      params: { path: { id: run, source } },
      body: { poses },
    }),
};

/** Requests for the predictions of runs on real robots. */
export const predictionsApi = {
  of: (run: string) => get("/api/runs/{id}/prediction", of(run)),
  /** Runs out of the ordinary for their robot. */
  unusual: async () => (await get("/api/unusual-runs")).runs,
};

/** Requests about the camera above the floor. */
export const overheadApi = {
  get: () => get("/api/overhead"),
  save: (measures: OverheadMeasures) => put("/api/overhead", { body: measures }),
  switchOff: () => del("/api/overhead"),
  /** The sheets to print, as a page. */
  sheets: async () => (await get("/api/overhead/sheets")).page,
  /** What it sees now; it stays on for some seconds after each request. */
  tryOut: () => post("/api/overhead/trial"),
  endTrial: () => del("/api/overhead/trial"),
};
