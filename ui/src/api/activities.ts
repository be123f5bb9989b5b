import { get, of, post } from "./client";

/** Requests about activities and about the programs that groups write for them. */
export const activitiesApi = {
  list: async () => (await get("/api/activities")).activities,
  one: (name: string) => get("/api/activities/{name}", { params: { path: { name } } }),
  examples: async () => (await get("/api/examples")).examples,
  /** The activities for which a group has run programs. */
  tried: async (group: string) => (await get("/api/groups/{id}/activities", of(group))).activities,
  /** The group's program for an activity, created if there is none. */
  begin: (group: string, activity: string) =>
    post("/api/groups/{id}/activities", { ...of(group), body: { activity } }),
};
