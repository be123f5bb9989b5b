import { get, of, put } from "./client";
import type { TruePose, Truth } from "./model";

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
