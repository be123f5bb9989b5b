import { del, get, post, put } from "./client";
import type { OverheadMeasures } from "./model";

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
