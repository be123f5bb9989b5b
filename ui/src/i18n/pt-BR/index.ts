export const row = {
  name: "Português",
  start: async () => (await import("./start")).start,
  later: async () => (await import("./later")).later,
};
