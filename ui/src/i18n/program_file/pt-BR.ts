/** A program as a file. */
export const ptBR = {
  takeAlong: "Levar o programa",
  takeAlongHint: "Guarda o programa num arquivo, para continuar em outro computador.",
  bringIn: "Trazer um programa",
  broughtIn: (n: number): string =>
    n === 0 ? "Este programa já estava aqui." : "O programa chegou, com toda a sua história.",
};
