import { LETTERS as KNOWN } from "../api/declared";
import { listenForKeys } from "../kit/listen";

/** The static letters of the LIBRAS alphabet, which the camera knows untaught; both signs for D are one letter. */
export const LETTERS: readonly string[] = KNOWN;

/** Calls back with the letter whose key is pressed, unless another element has the keyboard focus. */
export function listenForLetters(onLetter: (letter: string) => void): () => void {
  return listenForKeys((key) => {
    const letter = key.toUpperCase();
    const isLetter = LETTERS.includes(letter);
    if (isLetter) onLetter(letter);
    return isLetter;
  });
}
