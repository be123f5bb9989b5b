export const row = {
  name: "Português",
  start: async () => (await import("./start")).start,
  lazy: async () => (await import("./lazy")).lazy,
};
