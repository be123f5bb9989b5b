import type { editor as first } from "../pt-BR/editor";

/** Blockly's own words are in English. */
export const editor: Partial<typeof first> = {};
