import { get } from "./client";

/** Requests about the program itself. */
export const noticesApi = {
  /** Works of others in the package, with their licences; empty without a package. */
  text: async () => (await get("/api/notices")).text,
};
