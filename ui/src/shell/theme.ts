import { effect, signal } from "@preact/signals";
import { remember, remembered } from "./remembered";

export const THEMES = ["light", "dark", "contrast"] as const;
export type Theme = (typeof THEMES)[number];

const COOKIE = "pinel_theme";

function atFirst(): Theme {
  const value = remembered(COOKIE);
  const known = THEMES.find((name) => name === value);
  if (known) return known;
  return window.matchMedia?.("(prefers-contrast: more)").matches ? "contrast" : "light";
}

export const theme = signal<Theme>(atFirst());

effect(() => {
  document.documentElement.dataset.theme = theme.value;
});

export function setTheme(name: Theme): void {
  theme.value = name;
  remember(COOKIE, name);
}

export function nextTheme(name: Theme): Theme {
  return THEMES[(THEMES.indexOf(name) + 1) % THEMES.length] ?? "light";
}

export const prefersStill = () =>
  window.matchMedia?.("(prefers-reduced-motion: reduce)").matches ?? false;
