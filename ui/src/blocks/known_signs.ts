import { LETTERS } from "../api/declared";

/** Signs that a capture can answer, for the blocks. */
export interface KnownSigns {
  /** Names beside the letters, as the class spells them. */
  readonly named: readonly string[];
  /** Only a class teaches signs. */
  readonly hasClass: boolean;
}

let known: KnownSigns | null = null;

/** Sets what the blocks offer and warn of; null while it is not known: then nothing is warned of. */
export function setKnownSigns(signs: KnownSigns | null): void {
  known = signs;
}

export function knownSigns(): KnownSigns | null {
  return known;
}

/** Whether two names are one sign to a program, which ignores case. */
export function isSameSign(one: string, other: string): boolean {
  return one.toLowerCase() === other.toLowerCase();
}

/** Whether a capture can answer it; true where that is not known. "" is no sign. */
export function isKnownSign(name: string): boolean {
  if (known === null || name === "") return true;
  return [...LETTERS, ...known.named].some((one) => isSameSign(one, name));
}
