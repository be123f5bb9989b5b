import type { Texts } from "../../i18n";

const FORMAT = /^\d{4,12}$/;

/** The fault of a PIN and its repetition, as text; null if valid. */
export function pinFault(
  pin: string,
  again: string,
  texts: Pick<Texts["teacher"]["prepare"], "pinFormat" | "different">,
): string | null {
  if (!FORMAT.test(pin)) return texts.pinFormat;
  return pin === again ? null : texts.different;
}
