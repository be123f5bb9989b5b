import { get, of } from "./client";

/** Requests about the albums of stickers of groups. */
export const albumApi = {
  of: (group: string) => get("/api/groups/{id}/album", of(group)),
};
