import type { later } from "./pt-BR/later";
import type { start } from "./pt-BR/start";

/**
 * The texts that every pupil needs. Portuguese is written first: its shape is what every language must have, and a key
 * that is missing in another language does not compile.
 */
export type StartTexts = typeof start;

/** The texts of the teacher's part, fetched with the first part of the page that is fetched later. */
export type LaterTexts = typeof later;

export type Texts = StartTexts & LaterTexts;
