import { signal } from "@preact/signals";

/** The help is shown in the studio; the header opens and closes it. */
export const helpIsOpen = signal(false);
