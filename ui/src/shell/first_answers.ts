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
let earlySession: Promise<TeacherSession> | null = null;

function askProgram(id: string, sound = false): ProgramAnswer {
  return Promise.all([api.program(id, sound), api.groups()]);
}

function askStart(): StartAnswer {
  return Promise.all([api.groups(), classesApi.classrooms()]);
}

/** The server's status, after the texts of its language have loaded. */
async function askStatus(): Promise<Status> {
  const status = await api.status();
  if (isLanguage(status.language)) await fetchTexts(status.language);
  return status;
}

/** Starts the first requests of the page; each failure reaches the caller that asks for its response. */
export function startFirstRequests(): void {
  firstStatus = askStatus();
  const now = route.peek();
  if (now.screen === "studio") firstProgram = { id: now.program, answer: askProgram(now.program) };
  if (now.screen === "start") firstStart = askStart();
  if (now.screen === "start" || now.screen === "teacher")
    earlySession = classesApi.teacherSession();
  for (const answer of asked()) answer?.catch(() => {});
}

function asked() {
  return [firstStatus, firstProgram?.answer, firstStart, earlySession];
}

/** Resolves when all first requests have succeeded or failed. */
export async function firstRequestsSettled(): Promise<void> {
  await Promise.allSettled(asked());
}

/** The server's status; the first call returns the early request. */
export function serverStatus(): Promise<Status> {
  const early = firstStatus;
  firstStatus = null;
  return early ?? api.status();
}

/** A program and all groups; the first call returns the early request. */
export function programAndGroups(id: string, sound: boolean): ProgramAnswer {
  const early = firstProgram?.id === id && !sound ? firstProgram.answer : null;
  firstProgram = null;
  return early ?? askProgram(id, sound);
}

/** All groups and classes; the first call returns the early request. */
export function groupsAndClasses(): StartAnswer {
  const early = firstStart;
  firstStart = null;
  return early ?? askStart();
}

/** The teacher session; the first call returns the early request. */
export function firstTeacherSession(): Promise<TeacherSession> {
  const early = earlySession;
  earlySession = null;
  return early ?? classesApi.teacherSession();
}
