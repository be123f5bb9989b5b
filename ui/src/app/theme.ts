import { effect, signal } from "@preact/signals";

export const THEMES = ["light", "dark", "contrast"] as const;
export type Theme = (typeof THEMES)[number];

/** A cookie, because the port of the page, and with it local storage, may be another one each time. */
const COOKIE = "pinel_theme";
const YEAR_S = 31_536_000;

function remembered(): Theme {
  const value = document.cookie.match(/(?:^|; )pinel_theme=(\w+)/)?.[1];
  const known = THEMES.find((name) => name === value);
  if (known) return known;
  return window.matchMedia?.("(prefers-contrast: more)").matches ? "contrast" : "light";
}

export const theme = signal<Theme>(remembered());

effect(() => {
  document.documentElement.dataset.theme = theme.value;
});

export function setTheme(name: Theme): void {
  theme.value = name;
  // biome-ignore lint/suspicious/noDocumentCookie: the cookie store is missing in the webview of GTK
  document.cookie = `${COOKIE}=${name}; max-age=${YEAR_S}; path=/; samesite=strict`;
}

export function nextTheme(name: Theme): Theme {
  return THEMES[(THEMES.indexOf(name) + 1) % THEMES.length] ?? "light";
}

export const prefersStill = () =>
  window.matchMedia?.("(prefers-reduced-motion: reduce)").matches ?? false;
