import { del, get, post, put } from "./client";

const link = (name: string) => ({ params: { path: { link: name } } });

/** The real robots that this PC can drive. */
export const robotsApi = {
  all: async () => (await get("/api/real-robots")).robots,
  keep: (name: string, record: Record<string, unknown>) =>
    put("/api/real-robots/{link}", { ...link(name), body: { record } }),
  contact: (name: string) => post("/api/real-robots/{link}/contact", link(name)),
  forget: (name: string) => del("/api/real-robots/{link}", link(name)),
};
