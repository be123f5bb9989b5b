import type { ptBR } from "./pt-BR";

export const es: typeof ptBR = {
  takeAlong: "Llevar el programa",
  takeAlongHint: "Guarda el programa en un archivo, para seguir en otro ordenador.",
  bringIn: "Traer un programa",
  broughtIn: (n: number): string =>
    n === 0 ? "Este programa ya estaba aquí." : "El programa llegó, con toda su historia.",
};
