import { get, of, post } from "./client";

/** Activities, and the programs that are to solve them. */
export const activitiesApi = {
  list: async () => (await get("/api/activities")).activities,
  one: (name: string) => get("/api/activities/{name}", { params: { path: { name } } }),
  examples: async () => (await get("/api/examples")).examples,
  /** The activities that a group has run programs for. */
  tried: async (group: string) => (await get("/api/groups/{id}/activities", of(group))).activities,
  /** The group's program for an activity, created if there is none. */
  begin: (group: string, activity: string) =>
    post("/api/groups/{id}/activities", { ...of(group), body: { activity } }),
};
