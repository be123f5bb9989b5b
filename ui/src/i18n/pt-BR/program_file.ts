/** A program as a file. */
export const programFile = {
  takeAlong: "Levar o programa",
  takeAlongHint: "Salva o programa em um arquivo, para continuar em outro computador.",
  take: "Levar",
  bringIn: "Trazer um programa de outro computador",
};
