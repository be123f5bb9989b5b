import { api } from "../api/client";
import type { Group, ProgramWithVersion, Status } from "../api/model";
import { route } from "./route";

type ProgramAnswer = Promise<[ProgramWithVersion, Group[]]>;

let firstStatus: Promise<Status> | null = null;
let firstProgram: { id: string; answer: ProgramAnswer } | null = null;

function ask(id: string): ProgramAnswer {
  return Promise.all([api.program(id), api.groups()]);
}

/** Asks for what the page needs first; whoever takes an answer hears of its failure. */
export function askFirst(): void {
  firstStatus = api.status();
  const now = route.peek();
  firstProgram = now.screen === "studio" ? { id: now.program, answer: ask(now.program) } : null;
  for (const answer of [firstStatus, firstProgram?.answer]) answer?.catch(() => {});
}

/** Resolves when all that was asked for first is there, or has failed. */
export async function firstAnswers(): Promise<void> {
  await Promise.allSettled([firstStatus, firstProgram?.answer]);
}

/** How the server is; what was asked for at the start is handed out once. */
export function serverStatus(): Promise<Status> {
  const early = firstStatus;
  firstStatus = null;
  return early ?? api.status();
}

/** A program and all groups; what was asked for at the start is handed out once. */
export function programAndGroups(id: string): ProgramAnswer {
  const early = firstProgram?.id === id ? firstProgram.answer : null;
  firstProgram = null;
  return early ?? ask(id);
}
