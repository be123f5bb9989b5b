import type { ptBR } from "./pt-BR";

export const en: typeof ptBR = {
  passed: "You did it! The activity is solved.",
  missing: (what: string) => `Still missing for the activity: ${what}`,
  toTheEnd: "The program solves the activity: now let it run to its end.",
};
