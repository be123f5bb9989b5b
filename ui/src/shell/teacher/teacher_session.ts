import { computed, signal } from "@preact/signals";
import { classesApi } from "../../api/classes";
import { ApiError } from "../../api/errors";
import type { TeacherSession } from "../../api/model";
import { firstTeacherSession } from "../first_answers";

/** Whether a PIN exists and the teacher is signed in, by the server's last response; null before it. */
export const teacherSession = signal<TeacherSession | null>(null);

/** Whether the teacher was signed in when this window was last loaded. */
const FLAG = "pinel_teacher";

const SIGNED_OUT = ["teacher_only", "pin_missing"];

/** Whether the server refused because the teacher is not signed in. */
export const isSignedOut = (error: unknown): error is ApiError =>
  error instanceof ApiError && SIGNED_OUT.includes(error.code);

export async function loadTeacherSession(): Promise<TeacherSession> {
  const before = teacherSession.peek();
  // the early response is older than any state that is known
  const answer = await (before ? classesApi.teacherSession() : firstTeacherSession());
  // a sign-in or sign-out meanwhile is newer than this response
  if (teacherSession.peek() === before) teacherSession.value = answer;
  return teacherSession.peek() ?? answer;
}

/** Throws ApiError `pin_wrong`, or `pin_wait` with the seconds to wait. */
export async function signIn(pin: string): Promise<void> {
  teacherSession.value = await classesApi.enter(pin);
}

/** Sets the first PIN, or a new one while the teacher is signed in. */
export async function choosePin(pin: string): Promise<void> {
  teacherSession.value = await classesApi.choosePin(pin);
}

/** The actions of the teacher that have no response yet. */
const inProgress = new Set<Promise<unknown>>();

/** Ends the session, after what the teacher has begun: the server would refuse it, and a save would be lost. */
export async function signOut(): Promise<void> {
  while (inProgress.size > 0) await Promise.allSettled(inProgress);
  teacherSession.value = await classesApi.leave();
}

/** Called after a reload. Makes a request only if the teacher was signed in: pupils' pages do not wait. */
export async function restoreTeacherSession(): Promise<void> {
  if (!teacherSession.peek() && sessionStorage.getItem(FLAG)) await loadTeacherSession();
}

const waiting = signal<readonly (() => void)[]>([]);

/** Whether an action is waiting for the PIN. */
export const isPinAsked = computed(() => waiting.value.length > 0);

teacherSession.subscribe((now) => {
  if (now?.is_open) sessionStorage.setItem(FLAG, "1");
  else if (now) sessionStorage.removeItem(FLAG);
});

teacherSession.subscribe((now) => {
  if (!now?.is_open) return;
  const released = waiting.peek();
  waiting.value = [];
  for (const go of released) go();
});

/**
 * Performs an action of the teacher. If the session has ended, the page asks for the PIN and then retries: no input is
 * lost.
 */
export async function asTeacher<T>(work: () => Promise<T>): Promise<T> {
  const before = teacherSession.peek();
  const response = work();
  inProgress.add(response);
  try {
    return await response.finally(() => inProgress.delete(response));
  } catch (error) {
    if (!isSignedOut(error)) throw error;
    // if the refusal arrives after the teacher has signed in, the page does not ask for the PIN again
    if (teacherSession.peek()?.is_open && teacherSession.peek() !== before) return asTeacher(work);
    teacherSession.value = { has_pin: error.code !== "pin_missing", is_open: false };
    await new Promise<void>((resolve) => {
      waiting.value = [...waiting.peek(), resolve];
    });
    return asTeacher(work);
  }
}

/** Drops the actions that wait for the PIN: a later sign-in does not perform them. */
export function cancelWaiting(): void {
  waiting.value = [];
}
