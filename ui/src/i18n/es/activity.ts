import type { ptBR } from "./pt-BR";

export const es: typeof ptBR = {
  passed: "¡Lo lograron! La actividad está resuelta.",
  missing: (what: string) => `Todavía falta para la actividad: ${what}`,
  toTheEnd: "El programa resuelve la actividad: ahora déjenlo correr hasta el final.",
};
