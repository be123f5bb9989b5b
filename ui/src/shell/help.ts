import { signal } from "@preact/signals";
import { SettingById } from "./settings";

/** Whether the studio shows the help; the header opens and closes it. */
export const helpIsOpen = signal(false);

/** Id of the program that shows the guided first drive, which ends when the group leaves the studio. */
export const tourFor = signal<string | null>(null);

/** The step of each group's guided first drive, so that a reload of the page resumes it, or TOUR_OVER. */
export const tourSteps = new SettingById("pinel_tours");
export const TOUR_OVER = "over";
