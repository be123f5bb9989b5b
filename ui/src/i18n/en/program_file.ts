import type { programFile as first } from "../pt-BR/program_file";

export const programFile: typeof first = {
  takeAlong: "Take the program along",
  takeAlongHint: "Saves the program in a file, to go on at another PC.",
  take: "Take along",
  bringIn: "Bring a program from another PC",
};
