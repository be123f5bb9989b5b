import { computed, signal } from "@preact/signals";
import { setting } from "./settings";

/** Intervals in minutes after which the page proposes to swap who has the mouse; 0: never. */
export const TURN_MINUTES = [0, 5, 10, 15] as const;
export type TurnMinutes = (typeof TURN_MINUTES)[number];

const chosen = setting("pinel_turns");
const MINUTE_MS = 60_000;

const turnMinutes = computed(() => Number(chosen.value) as TurnMinutes);

/** What is set for the class of the group; null where this PC decides. */
export const turnsOfClass = signal<TurnMinutes | null>(null);

const minutesNow = computed(() => turnsOfClass.value ?? turnMinutes.value);

/** Whether it is time to swap. */
export const isTurnOver = signal(false);

let timer = 0;
let whose = "";

/** Counts a group's turns from its arrival, across its programs. */
export function startTurns(group: string): void {
  if (group !== whose) restartTurn();
  whose = group;
}

/** Restarts the interval, after a swap or for another group. */
export function restartTurn(): void {
  clearTimeout(timer);
  isTurnOver.value = false;
  const minutes = minutesNow.peek();
  if (minutes === 0) return;
  timer = window.setTimeout(() => {
    isTurnOver.value = true;
  }, minutes * MINUTE_MS);
}

minutesNow.subscribe(restartTurn);
