import type { LanguageRow } from "../languages";

export const row: LanguageRow = {
  name: "Español",
  start: async () => (await import("./start")).start,
  lazy: async () => (await import("./lazy")).lazy,
};
