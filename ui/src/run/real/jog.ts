import { computed, signal } from "@preact/signals";
import { robotsApi } from "../../api/robots";
import { type Problem, problemOf } from "../../kit/requests/problem";
import { robotStates } from "./robot_state";

export type Direction = "ahead" | "back" | "left" | "right";

interface Held {
  readonly link: string;
  readonly direction: Direction;
}

/** Interval of the jog requests. The server stops the robot 0.2 s after the last request. */
const REPEAT_MS = 100;

const JOG_FACTORS: Readonly<Record<Direction, readonly [drive: number, turn: number]>> = {
  ahead: [1, 0],
  back: [-1, 0],
  left: [0, 1],
  right: [0, -1],
};

/** The jog key or button that a person holds down; null for none. */
export const held = signal<Held | null>(null);

/** Why the server refused the last jog request. */
export const jogFault = signal<Problem | null>(null);

/** Link of the robot that is jogged with keys, from this page or another one. */
export const joggedLink = computed<string | null>(
  () => Object.values(robotStates.value).find(({ use }) => use === "jog")?.link ?? null,
);

let timer = 0;
let isAsking = false;

/**
 * Jogs the robot until `release`. The robot needs repeated requests, so it also stops when the
 * page ends.
 */
export function hold(link: string, direction: Direction): void {
  jogFault.value = null;
  held.value = { link, direction };
  window.clearInterval(timer);
  timer = window.setInterval(ask, REPEAT_MS);
  ask();
}

/** Stops the robot that `hold` jogs. */
export function release(): void {
  const { value: before } = held;
  if (!before) return;
  window.clearInterval(timer);
  held.value = null;
  robotsApi.jog(before.link, 0, 0).catch(() => {}); // if this fails, the robot stops soon anyway
}

/** Halts a robot at once, even if another page jogs it. */
export async function haltKeys(link: string): Promise<void> {
  window.clearInterval(timer);
  held.value = null;
  await robotsApi.halt(link);
}

function ask(): void {
  const { value: now } = held;
  // if the server does not respond, no further requests queue up
  if (!now || isAsking) return;
  isAsking = true;
  robotsApi
    .jog(now.link, ...JOG_FACTORS[now.direction])
    .catch((error) => {
      release();
      jogFault.value = problemOf(error);
    })
    .finally(() => {
      isAsking = false;
    });
}
