/**
 * On a PC without a language of its own (LANG=C) WebKit says that it speaks "C", which no formatter takes. Libraries ask
 * while they are evaluated, so main.tsx imports this before them.
 */
export function mendLanguage(browser: Navigator): void {
  try {
    Intl.getCanonicalLocales(browser.language);
  } catch {
    Object.defineProperty(browser, "language", { value: "pt-BR", configurable: true });
  }
}

mendLanguage(navigator);
