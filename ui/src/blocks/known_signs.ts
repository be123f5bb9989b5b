import { LETTERS } from "../api/declared";

/** Signs that a capture can answer; the blocks offer them. */
export interface KnownSigns {
  /** Names of the taught signs, in the spelling of the class. */
  readonly named: readonly string[];
  /** Whether the group belongs to a class; only a class can teach signs. */
  readonly hasClass: boolean;
}

let known: KnownSigns | null = null;

/**
 * Sets the signs that blocks offer. Null: the list is not loaded yet, and blocks show no warning.
 */
export function setKnownSigns(signs: KnownSigns | null): void {
  known = signs;
}

export function knownSigns(): KnownSigns | null {
  return known;
}

/** Whether a program treats two names as the same sign; it ignores case. */
export function isSameSign(one: string, other: string): boolean {
  return one.toLowerCase() === other.toLowerCase();
}

/** Whether a capture can answer the sign; true if the list is not loaded. "" stands for no sign. */
export function isKnownSign(name: string): boolean {
  if (known === null || name === "") return true;
  return [...LETTERS, ...known.named].some((one) => isSameSign(one, name));
}
