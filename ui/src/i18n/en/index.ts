import type { LanguageRow } from "../languages";

export const row: LanguageRow = {
  name: "English",
  start: async () => (await import("./start")).start,
  lazy: async () => (await import("./lazy")).lazy,
};
