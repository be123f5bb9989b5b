import type { ptBR } from "./pt-BR";

export const en: typeof ptBR = {
  takeAlong: "Take the program along",
  takeAlongHint: "Saves the program in a file, to go on at another PC.",
  take: "Take along",
  bringIn: "Bring a program from another PC",
};
