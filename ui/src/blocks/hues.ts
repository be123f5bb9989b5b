import { CATEGORY_COLOURS } from "./categories";

/**
 * The hue of each category. The start block belongs to no category; its hue differs from all
 * others.
 */
export const HUES = { start: "#5b5446", ...CATEGORY_COLOURS } as const;

export type Category = keyof typeof HUES;
