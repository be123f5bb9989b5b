import { api } from "../api/client";
import type { Group, ProgramWithVersion } from "../api/model";
import { route } from "./route";

type Answer = Promise<[ProgramWithVersion, Group[]]>;

let first: { id: string; answer: Answer } | null = null;

function ask(id: string): Answer {
  return Promise.all([api.program(id), api.groups()]);
}

/** Asks for the program of the address while the page still finds out how its server is. */
export function askForFirstProgram(): void {
  const now = route.peek();
  if (now.screen !== "studio") return;
  first = { id: now.program, answer: ask(now.program) };
  // whoever takes it hears of the failure
  first.answer.catch(() => {});
}

/** A program and all groups; what was asked for at the start is handed out once. */
export function programAndGroups(id: string): Answer {
  const early = first?.id === id ? first.answer : null;
  first = null;
  return early ?? ask(id);
}
