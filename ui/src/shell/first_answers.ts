import { classesApi } from "../api/classes";
import { api } from "../api/client";
import type { Classroom, Group, ProgramWithVersion, Status, TeacherSession } from "../api/model";
import { fetchTexts } from "../i18n";
import { isLanguage } from "../i18n/languages";
import { route } from "./route";

type ProgramAnswer = Promise<[ProgramWithVersion, Group[]]>;
type StartAnswer = Promise<[Group[], Classroom[]]>;

let firstStatus: Promise<Status> | null = null;
let firstProgram: { id: string; answer: ProgramAnswer } | null = null;
let firstStart: StartAnswer | null = null;
let firstSession: Promise<TeacherSession> | null = null;

function askProgram(id: string): ProgramAnswer {
  return Promise.all([api.program(id), api.groups()]);
}

function askStart(): StartAnswer {
  return Promise.all([api.groups(), classesApi.classrooms()]);
}

/** How the server is, once the texts of its language are there. */
async function askStatus(): Promise<Status> {
  const status = await api.status();
  if (isLanguage(status.language)) await fetchTexts(status.language);
  return status;
}

/** Asks for what the page needs first; whoever takes an answer hears of its failure. */
export function askFirst(): void {
  firstStatus = askStatus();
  const now = route.peek();
  if (now.screen === "studio") firstProgram = { id: now.program, answer: askProgram(now.program) };
  if (now.screen === "start") firstStart = askStart();
  if (now.screen === "start" || now.screen === "teacher")
    firstSession = classesApi.teacherSession();
  for (const answer of asked()) answer?.catch(() => {});
}

function asked() {
  return [firstStatus, firstProgram?.answer, firstStart, firstSession];
}

/** Resolves when all that was asked for first is there, or has failed. */
export async function firstAnswers(): Promise<void> {
  await Promise.allSettled(asked());
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
  return early ?? askProgram(id);
}

/** All groups and classes; what was asked for at the start is handed out once. */
export function groupsAndClasses(): StartAnswer {
  const early = firstStart;
  firstStart = null;
  return early ?? askStart();
}

/** The state of the teacher's session; what was asked for at the start is handed out once. */
export function sessionAtFirst(): Promise<TeacherSession> {
  const early = firstSession;
  firstSession = null;
  return early ?? classesApi.teacherSession();
}
