import type { Texts } from "../../i18n";

const FORMAT = /^\d{4,12}$/;

/** What is wrong with a PIN that was typed twice, in words; null for nothing. */
export function pinFault(
  pin: string,
  again: string,
  words: Pick<Texts["teacher"]["prepare"], "pinFormat" | "different">,
): string | null {
  if (!FORMAT.test(pin)) return words.pinFormat;
  return pin === again ? null : words.different;
}
