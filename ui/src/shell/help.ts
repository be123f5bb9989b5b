import { effect, signal } from "@preact/signals";
import { type Route, route } from "./route";
import { SettingById } from "./settings";

/** Whether the studio shows the help; the header opens and closes it. */
export const helpIsOpen = signal(false);

/** The screen from which the manuals were opened. */
export const manualsOrigin = signal<Route>({ screen: "start" });
effect(() => {
  if (route.value.screen !== "manuals") manualsOrigin.value = route.value;
});

/** Id of the program that shows the guided first drive, which ends when the group leaves the studio. */
export const tourFor = signal<string | null>(null);

/** The step of each group's guided first drive, so that a reload of the page resumes it, or TOUR_OVER. */
export const tourSteps = new SettingById("pinel_tours");
export const TOUR_OVER = "over";
