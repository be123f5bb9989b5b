import { computed, signal } from "@preact/signals";
import { robotsApi } from "../../api/robots";
import { type Problem, problemOf } from "../../kit/requests/problem";
import { robotStates } from "./robot_state";

export type Direction = "ahead" | "back" | "left" | "right";

interface Held {
  readonly link: string;
  readonly direction: Direction;
}

/** The server's robot stands a fifth of a second after the last of these. */
const REPEAT_MS = 100;

const JOG_FACTORS: Readonly<Record<Direction, readonly [drive: number, turn: number]>> = {
  ahead: [1, 0],
  back: [-1, 0],
  left: [0, 1],
  right: [0, -1],
};

/** The key or button that is held; null for none. */
export const held = signal<Held | null>(null);

/** Why the server refused the last one. */
export const jogFault = signal<Problem | null>(null);

/** The robot that is moved by keys, from this page or another one. */
export const joggedLink = computed<string | null>(
  () => Object.values(robotStates.value).find(({ use }) => use === "jog")?.link ?? null,
);

let timer = 0;
let isAsking = false;

/** Moves the robot until `release`; what ends the page ends the requests, and without them the robot stands. */
export function hold(link: string, direction: Direction): void {
  jogFault.value = null;
  held.value = { link, direction };
  window.clearInterval(timer);
  timer = window.setInterval(ask, REPEAT_MS);
  ask();
}

/** Stands. */
export function release(): void {
  const { value: before } = held;
  if (!before) return;
  window.clearInterval(timer);
  held.value = null;
  robotsApi.jog(before.link, 0, 0).catch(() => {}); // without it, too, the robot stands soon
}

/** Lets go of a robot at once, also one that another page moves. */
export async function haltKeys(link: string): Promise<void> {
  window.clearInterval(timer);
  held.value = null;
  await robotsApi.halt(link);
}

function ask(): void {
  const { value: now } = held;
  // a server that does not answer gets no queue of requests
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
