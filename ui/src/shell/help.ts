import { signal } from "@preact/signals";
import { SettingById } from "./settings";

/** The help is shown in the studio; the header opens and closes it. */
export const helpIsOpen = signal(false);

/** The program in which the guided first drive is shown; it ends when its studio is left. */
export const tourFor = signal<string | null>(null);

/** The step of each group's guided first drive, for a page that is loaded again in the middle; then that it is over. */
export const tourSteps = new SettingById("pinel_tours");
export const TOUR_OVER = "over";
