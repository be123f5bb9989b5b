/** Height of the picture by that of its smallest text: readable from eight metres on a picture of usual size. */
const TEXTS_PER_HEIGHT = 28;
/** Height of the smallest text that the floor draws in pixels. */
const FLOOR_TEXT_PX = 13;

/** Minimum height of a text in this window; an upright window counts as a picture of 4 : 3. */
export const textPx = () =>
  Math.min(window.innerHeight, window.innerWidth * 0.75) / TEXTS_PER_HEIGHT;

/** How much larger the floor is drawn. */
export const floorMagnification = () => textPx() / FLOOR_TEXT_PX;
