import { texts } from ".";
import type { Texts } from "./texts";

/** A label and its value: "Robô: pronto", in French with a space before the colon. */
export const labelled = (label: string | number, value: string): string =>
  texts.value.units.labelled({ label, value });

/** What a sign is called: a letter, or any other name that a class gave it. */
export const namedSign = (sign: string, { sign: texts }: Texts): string =>
  /^\p{L}$/u.test(sign) ? texts.letter({ sign }) : texts.named({ sign });

/** When something was changed: "em 19 de nov.", but "hoje" and "há 5 min" without a preposition. */
export const changedText = (when: string, { work }: Texts): string =>
  /^\d/.test(when) ? work.changedOn({ when }) : work.changed({ when });

/** Which hints were read: hints are opened in their order. */
export function hintsRead(n: number, { review: { detail } }: Texts): string {
  if (n > 2) return detail.hintsRead({ n });
  return [detail.noneRead, detail.firstRead, detail.twoRead][n] ?? detail.noneRead;
}
