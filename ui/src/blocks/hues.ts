import { CATEGORY_COLOURS } from "./categories";

/** The page's hue of each category; the start block stands outside of them, and keeps clear of all. */
export const HUES = { start: "#5b5446", ...CATEGORY_COLOURS } as const;

export type Category = keyof typeof HUES;
