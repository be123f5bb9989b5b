import { computed, signal } from "@preact/signals";
import { LETTERS as KNOWN } from "../api/declared";
import { ApiError } from "../api/errors";
import type { Sign } from "../api/model";
import { signsApi } from "../api/signs";
import { isSameSign } from "../blocks/known_signs";
import { listenForKeys } from "../kit/listen";

/** The static letters of the Libras alphabet, which the camera knows untaught; both signs for D are one letter. */
export const LETTERS: readonly string[] = KNOWN;

/** What captures can answer: letters, then what the class in use taught besides. Null until the server has said. */
export const signs = signal<readonly Sign[] | null>(null);

/** Their names; the letters until the server has said. */
export const signNames = computed(() => signs.value?.map(({ name }) => name) ?? LETTERS);

/** The class in use; null for a group without a class, undefined before one was chosen. */
export const classOfSigns = signal<string | null | undefined>(undefined);

let pending: Promise<void> = Promise.resolve();

/** From now on the camera, the blocks and the panel know what this class taught; null is a group without a class. */
export function chooseSigns(classroom: string | null): Promise<void> {
  if (classroom !== classOfSigns.peek()) signs.value = null;
  classOfSigns.value = classroom;
  // one after the other: of two requests at once the camera would keep the one that arrives last
  pending = pending.then(() => updateSigns(classroom, () => signsApi.use(classroom)));
  return pending;
}

/** The server may have been started again. */
export async function chooseSignsAgain(): Promise<void> {
  const { value: classroom } = classOfSigns;
  if (classroom !== undefined) await chooseSigns(classroom);
}

/** Asks for the list anew when what this class taught has changed; null is any class. */
export async function askForSigns(changed: string | null): Promise<void> {
  const { value: classroom } = classOfSigns;
  if (!classroom || (changed !== null && changed !== classroom)) return;
  await updateSigns(classroom, () => signsApi.list(classroom));
}

/** A sign as the class spells it; a name that is none is given back. */
export function canonicalSign(name: string): string {
  return signNames.value.find((one) => isSameSign(one, name)) ?? name;
}

/** Calls back with the sign of one character whose key is pressed, unless another element has the keyboard focus. */
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
    // a class that was deleted taught nothing; without a server the letters stay until it is back
    const isDeleted = error instanceof ApiError && error.code === "classroom_not_found";
    if (isDeleted && classOfSigns.peek() === classroom) void chooseSigns(null);
  }
}
