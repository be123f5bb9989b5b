import type { programFile as first } from "../pt-BR/program_file";

export const programFile: typeof first = {
  takeAlong: "Llevar el programa",
  takeAlongHint: "Guarda el programa en un archivo, para seguir en otra computadora.",
  take: "Llevar",
  bringIn: "Traer un programa de otra computadora",
};
