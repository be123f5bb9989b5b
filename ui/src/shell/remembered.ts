import { put } from "../api/client";

/**
 * Settings of this PC. The server keeps them and writes them into the page, because the page's port may change at every
 * start, and cookies end with the window.
 */
const kept: Record<string, string> = JSON.parse(document.documentElement.dataset.kept ?? "{}");

/** A setting of this PC, or null. */
export function remembered(name: string): string | null {
  return kept[name] ?? ofEarlierRelease(name);
}

export function remember(name: string, value: string): void {
  if (kept[name] === value) return;
  kept[name] = value;
  // where the server cannot keep it, it holds until the page is left
  put("/api/settings/page", { body: { name, value } }).catch(() => {});
}

/** Earlier releases kept settings in cookies; each is read once, and goes to the server. */
function ofEarlierRelease(name: string): string | null {
  const value = document.cookie.match(new RegExp(`(?:^|; )${name}=([\\w-]+)`))?.[1] ?? null;
  if (value !== null) {
    remember(name, value);
    // biome-ignore lint/suspicious/noDocumentCookie: the cookie store is missing in the webview of GTK
    document.cookie = `${name}=; max-age=0; path=/; samesite=strict`;
  }
  return value;
}
