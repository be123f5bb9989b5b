import { del, of, post } from "./client";
import type { NewCloud } from "./model";

/** Requests about the same program in 50 realistic robots; their results are events of the stream. */
export const cloudsApi = {
  prepare: () => post("/api/clouds/ready"),
  begin: (body: NewCloud) => post("/api/clouds", { body }),
  stop: (id: string) => del("/api/clouds/{id}", of(id)),
};
