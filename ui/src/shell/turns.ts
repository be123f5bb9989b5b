import { signal } from "@preact/signals";
import { remember, remembered } from "./remembered";

/** After so many minutes the page proposes to change who has the mouse; 0: never. */
export const TURN_MINUTES = [0, 5, 10, 15] as const;
export type TurnMinutes = (typeof TURN_MINUTES)[number];

const COOKIE = "pinel_turns";
const MINUTE_MS = 60_000;

export const turnMinutes = signal<TurnMinutes>(
  TURN_MINUTES.find((one) => String(one) === remembered(COOKIE)) ?? 0,
);

export function setTurnMinutes(chosen: TurnMinutes): void {
  turnMinutes.value = chosen;
  remember(COOKIE, String(chosen));
}

/** Whether it is time to swap. */
export const isTurn = signal(false);

let timer = 0;
let whose = "";

/** A group is at work: its turns are counted from when it came, whatever program it opens. */
export function countTurns(group: string): void {
  if (group !== whose) nextTurn();
  whose = group;
}

/** They have swapped, or somebody else came: the minutes begin anew. */
export function nextTurn(): void {
  clearTimeout(timer);
  isTurn.value = false;
  const minutes = turnMinutes.peek();
  if (minutes === 0) return;
  timer = window.setTimeout(() => {
    isTurn.value = true;
  }, minutes * MINUTE_MS);
}

turnMinutes.subscribe(nextTurn);
