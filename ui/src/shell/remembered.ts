const YEAR_S = 31_536_000;

/**
 * What this PC remembers of how the page was left, or null. In cookies, because the port of the page, and with it
 * local storage, may be another one each time.
 */
export function remembered(name: string): string | null {
  return document.cookie.match(new RegExp(`(?:^|; )${name}=([\\w-]+)`))?.[1] ?? null;
}

export function remember(name: string, value: string): void {
  // biome-ignore lint/suspicious/noDocumentCookie: the cookie store is missing in the webview of GTK
  document.cookie = `${name}=${value}; max-age=${YEAR_S}; path=/; samesite=strict`;
}
