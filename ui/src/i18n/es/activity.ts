import type { activity as first } from "../pt-BR/activity";

export const activity: typeof first = {
  passed: "¡Lo lograron! La actividad está resuelta.",
  missing: (what: string) => `Todavía no: ${what}`,
  toTheEnd: "El programa resuelve la actividad: ahora déjenlo correr hasta el final.",
  goal: "Dibujo de lo que el robot debe hacer",
  showGoal: "Ver lo que el robot debe hacer",
  ofLesson: (title: string) => `La misión de la clase es «${title}».`,
  openOfLesson: "Abrir la misión",
  mission: "Misión",
  fold: "Plegar la misión",
  unfold: "Mostrar la misión",
  hints: "Pistas",
  openHint: (n: number, all: number) => `Abrir la pista ${n} de ${all}`,
  done: "¡Misión cumplida!",
  next: (title: string) => `Siguiente: ${title}`,
  unknown:
    "Esta misión es de un PINEL más nuevo. Los bloques funcionan, pero aquí no se comprueba.",
  locked: "El mundo es el de la misión",
  open: "Actividades",
  choose: "¿Qué misión quieren?",
  paths: {
    moves: "Primeros movimientos",
    shapes: "Figuras y ángulos",
    decisions: "Decisiones y señas",
    sensors: "Sensores y laberintos",
    games: "Juegos",
    others: "Otras",
  },
  minutes: (n: number) => `${n} min`,
  states: { tried: "ya intentada", passed: "cumplida" },
};
