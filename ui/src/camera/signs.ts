import { computed, signal } from "@preact/signals";
import { LETTERS as KNOWN } from "../api/declared";
import { ApiError } from "../api/errors";
import type { Sign } from "../api/model";
import { signsApi } from "../api/signs";
import { isSameSign } from "../blocks/known_signs";
import { listenForKeys } from "../kit/listen";

/**
 * The static letters of the Libras alphabet, which need no teaching; both signs for D are one
 * letter.
 */
export const LETTERS: readonly string[] = KNOWN;

/**
 * All signs that a capture can answer: letters, then taught signs of the class in use. Null until
 * the server has sent the list.
 */
export const signs = signal<readonly Sign[] | null>(null);

/** The names of these signs; only the letters until the server has sent the list. */
export const signNames = computed(() => signs.value?.map(({ name }) => name) ?? LETTERS);

/** The class in use; null for a group without a class, undefined before the first choice. */
export const classOfSigns = signal<string | null | undefined>(undefined);

let pending: Promise<void> = Promise.resolve();

/** Makes camera, blocks and panel use the signs of a class; null stands for no class. */
export function chooseSigns(classroom: string | null): Promise<void> {
  if (classroom !== classOfSigns.peek()) signs.value = null;
  classOfSigns.value = classroom;
  // one request after the other: of two parallel requests, the camera would use the later arrival
  pending = pending.then(() => updateSigns(classroom, () => signsApi.use(classroom)));
  return pending;
}

/** Repeats the choice, because the server may have restarted. */
export async function chooseSignsAgain(): Promise<void> {
  const { value: classroom } = classOfSigns;
  if (classroom !== undefined) await chooseSigns(classroom);
}

/**
 * Requests the list again if the signs of the class in use have changed; null stands for any class.
 */
export async function askForSigns(changed: string | null): Promise<void> {
  const { value: classroom } = classOfSigns;
  if (!classroom || (changed !== null && changed !== classroom)) return;
  await updateSigns(classroom, () => signsApi.list(classroom));
}

/** The name of a sign in the spelling of the class; an unknown name is returned unchanged. */
export function canonicalSign(name: string): string {
  return signNames.value.find((one) => isSameSign(one, name)) ?? name;
}

/**
 * Calls back if the user presses the key of a one-letter sign and no other element has the keyboard
 * focus.
 */
export function listenForSigns(onSign: (sign: string) => void): () => void {
  return listenForKeys((key) => {
    const sign = signNames.peek().find((one) => one.length === 1 && isSameSign(one, key));
    if (sign !== undefined) onSign(sign);
    return sign !== undefined;
  });
}

async function updateSigns(
  classroom: string | null,
  ask: () => Promise<readonly Sign[]>,
): Promise<void> {
  if (classOfSigns.peek() !== classroom) return;
  try {
    const found = await ask();
    if (classOfSigns.peek() === classroom) signs.value = found;
  } catch (error) {
    // a deleted class has no signs; if the server is unreachable, the list stays as it is
    const isDeleted = error instanceof ApiError && error.code === "classroom_not_found";
    if (isDeleted && classOfSigns.peek() === classroom) void chooseSigns(null);
  }
}
