/** A program as a file. */
export const ptBR = {
  takeAlong: "Levar o programa",
  takeAlongHint: "Guarda o programa num arquivo, para continuar em outro computador.",
  take: "Levar",
  bringIn: "Trazer um programa de outro computador",
};
