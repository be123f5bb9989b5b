import type { activity as first } from "../pt-BR/activity";

export const activity: typeof first = {
  passed: "¡Lo lograron! La actividad está resuelta.",
  missing: (what: string) => `Todavía falta para la actividad: ${what}`,
  toTheEnd: "El programa resuelve la actividad: ahora déjenlo correr hasta el final.",
  goal: "Dibujo de lo que el robot debe hacer",
  showGoal: "Ver lo que el robot debe hacer",
};
