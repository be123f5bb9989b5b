import { computed, signal } from "@preact/signals";
import { classesApi } from "../api/classes";
import { ApiError } from "../api/errors";
import type { Door } from "../api/model";
import { doorAtFirst } from "./first_answers";

/** The teacher's door as the server last told it, null until it has. */
export const door = signal<Door | null>(null);

/** Whether the door was open in this window when the page was last drawn anew. */
const FLAG = "pinel_teacher";

const SHUT = ["teacher_only", "pin_missing"];

/** Whether the server refused because the door is shut. */
export const isShut = (error: unknown): error is ApiError =>
  error instanceof ApiError && SHUT.includes(error.code);

/** Asks how the door is. */
export async function knowDoor(): Promise<Door> {
  door.value = await doorAtFirst();
  return door.value;
}

/** Opens the door; throws ApiError `pin_wrong`, or `pin_wait` with the seconds to wait. */
export async function enterDoor(pin: string): Promise<void> {
  door.value = await classesApi.enter(pin);
}

/** The first PIN, or another while the door is open. */
export async function choosePin(pin: string): Promise<void> {
  door.value = await classesApi.choosePin(pin);
}

export async function leaveDoor(): Promise<void> {
  door.value = await classesApi.leave();
}

/** After a reload: asks only where the door was open, which is not where pupils wait for their blocks. */
export async function knowDoorAgain(): Promise<void> {
  if (!door.peek() && sessionStorage.getItem(FLAG)) await knowDoor();
}

door.subscribe((now) => {
  if (now?.is_open) sessionStorage.setItem(FLAG, "1");
  else if (now) sessionStorage.removeItem(FLAG);
});

const waiting = signal<readonly (() => void)[]>([]);

/** Whether something that was begun waits for the PIN. */
export const pinAsked = computed(() => waiting.value.length > 0);

door.subscribe((now) => {
  if (!now?.is_open) return;
  const released = waiting.peek();
  waiting.value = [];
  for (const go of released) go();
});

/**
 * Does what only the teacher may. Where the door has shut meanwhile it waits for the PIN, which the page then asks for,
 * and goes on: nothing that was typed is lost.
 */
export async function asTeacher<T>(work: () => Promise<T>): Promise<T> {
  try {
    return await work();
  } catch (error) {
    if (!isShut(error)) throw error;
    door.value = { has_pin: error.code !== "pin_missing", is_open: false };
    await new Promise<void>((resolve) => {
      waiting.value = [...waiting.peek(), resolve];
    });
    return asTeacher(work);
  }
}

/** Nobody waits for the PIN any more: what was asked for is not done when it is given later. */
export function giveUpWaiting(): void {
  waiting.value = [];
}
