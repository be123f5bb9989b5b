const YEAR_S = 31_536_000;

/**
 * A setting of this PC, or null. Stored in cookies, because the page's port, and with it local storage, may change at
 * every start.
 */
export function remembered(name: string): string | null {
  return document.cookie.match(new RegExp(`(?:^|; )${name}=([\\w-]+)`))?.[1] ?? null;
}

export function remember(name: string, value: string): void {
  // biome-ignore lint/suspicious/noDocumentCookie: the cookie store is missing in the webview of GTK
  document.cookie = `${name}=${value}; max-age=${YEAR_S}; path=/; samesite=strict`;
}
