import { computed, signal } from "@preact/signals";
import { setting } from "./settings";

/** Minutes after which the page proposes that the pupils swap the mouse; 0: never. */
export const SWAP_MINUTES = [0, 5, 10, 15] as const;
export type SwapMinutes = (typeof SWAP_MINUTES)[number];

const chosen = setting("pinel_turns");
const MINUTE_MS = 60_000;

const swapMinutes = computed(() => Number(chosen.value) as SwapMinutes);

/** The minutes that the teacher set for the class of the group; null for the setting of this PC. */
export const swapMinutesOfClass = signal<SwapMinutes | null>(null);

const minutesNow = computed(() => swapMinutesOfClass.value ?? swapMinutes.value);

/** Whether it is time to swap. */
export const isSwapDue = signal(false);

let timer = 0;
let whose = "";

/** Starts the interval when a group arrives; the interval continues across the group's programs. */
export function startSwapTimer(group: string): void {
  if (group !== whose) restartSwapTimer();
  whose = group;
}

/** Restarts the interval, after a swap or for another group. */
export function restartSwapTimer(): void {
  clearTimeout(timer);
  isSwapDue.value = false;
  const minutes = minutesNow.peek();
  if (minutes === 0) return;
  timer = window.setTimeout(() => {
    isSwapDue.value = true;
  }, minutes * MINUTE_MS);
}

minutesNow.subscribe(restartSwapTimer);
