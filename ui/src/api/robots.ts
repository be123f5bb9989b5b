import { del, get, post, put } from "./client";

const link = (name: string) => ({ params: { path: { link: name } } });

/** Requests about the real robots that this PC can drive. */
export const robotsApi = {
  all: async () => (await get("/api/real-robots")).robots,
  save: (name: string, record: Record<string, unknown>) =>
    put("/api/real-robots/{link}", { ...link(name), body: { record } }),
  contact: (name: string) => post("/api/real-robots/{link}/contact", link(name)),
  find: (name: string, record: Record<string, unknown>) =>
    post("/api/real-robots/{link}/find", { ...link(name), body: { record } }),
  watch: (name: string, isFirst: boolean) =>
    post("/api/real-robots/{link}/watch", { ...link(name), body: { is_first: isFirst } }),
  jog: (name: string, drive: number, turn: number) =>
    post("/api/real-robots/{link}/jog", {
      ...link(name),
      body: { drive, turn, sent_ms: Date.now() },
      keepalive: true,
    }),
  halt: (name: string) => del("/api/real-robots/{link}/jog", link(name)),
  setStartHere: (name: string) => post("/api/real-robots/{link}/at-start", link(name)),
  forget: (name: string) => del("/api/real-robots/{link}", link(name)),
};
