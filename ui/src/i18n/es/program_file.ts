import type { ptBR } from "./pt-BR";

export const es: typeof ptBR = {
  takeAlong: "Llevar el programa",
  takeAlongHint: "Guarda el programa en un archivo, para seguir en otra computadora.",
  take: "Llevar",
  bringIn: "Traer un programa de otra computadora",
};
