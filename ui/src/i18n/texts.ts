import type { lazy } from "./pt-BR/lazy";
import type { start } from "./pt-BR/start";

/**
 * The texts that every pupil needs. Portuguese is written first: its shape is what every language must have, and a key
 * that is missing in another language does not compile.
 */
export type StartTexts = typeof start;

/** The texts of the teacher's part, fetched with the first part of the page that is loaded lazily. */
export type LazyTexts = typeof lazy;

export type Texts = StartTexts & LazyTexts;
