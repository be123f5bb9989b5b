/**
 * On a PC without a language (LANG=C) WebKit reports the language "C", which `Intl` refuses.
 * Libraries read the language while they are evaluated, so main.tsx imports this module before them.
 */
export function fixLanguage(browser: Navigator): void {
  try {
    Intl.getCanonicalLocales(browser.language);
  } catch {
    Object.defineProperty(browser, "language", { value: "pt-BR", configurable: true });
  }
}

fixLanguage(navigator);
