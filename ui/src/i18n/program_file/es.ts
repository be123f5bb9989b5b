import type { ptBR } from "./pt-BR";

export const es: typeof ptBR = {
  takeAlong: "Llevar el programa",
  takeAlongHint: "Guarda el programa en un archivo, para seguir en otro ordenador.",
  take: "Llevar",
  bringIn: "Traer un programa de otro ordenador",
};
