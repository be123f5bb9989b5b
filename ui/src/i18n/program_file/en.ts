import type { ptBR } from "./pt-BR";

export const en: typeof ptBR = {
  takeAlong: "Take the program along",
  takeAlongHint: "Saves the program in a file, to go on at another PC.",
  bringIn: "Bring a program in",
  broughtIn: (n: number): string =>
    n === 0 ? "This program was here already." : "The program has come, with its whole history.",
};
