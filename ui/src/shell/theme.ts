import { computed, effect } from "@preact/signals";
import { choose, setting } from "./settings";

export const THEMES = ["light", "dark", "contrast"] as const;
export type Theme = (typeof THEMES)[number];

const chosen = setting("pinel_theme");

/** The theme that the system's settings suggest, used if nobody chose a theme. */
const ofSystem = (): Theme =>
  window.matchMedia?.("(prefers-contrast: more)").matches ? "contrast" : "light";

export const theme = computed<Theme>(() => chosen.value || ofSystem());

effect(() => {
  document.documentElement.dataset.theme = theme.value;
});

export function setTheme(name: Theme): void {
  void choose("pinel_theme", name);
}

export function nextTheme(name: Theme): Theme {
  return THEMES[(THEMES.indexOf(name) + 1) % THEMES.length] ?? "light";
}

export const prefersStill = () =>
  window.matchMedia?.("(prefers-reduced-motion: reduce)").matches ?? false;
