/** Shapes of the lucide family (ISC licence), 24 x 24, drawn with a stroke. */
const SHAPES = {
  play: "M6 4v16l13-8z",
  arrowUp: "m5 12 7-7 7 7M12 19V5",
  arrowDown: "M12 5v14m7-7-7 7-7-7",
  rotateLeft: "M3 12a9 9 0 1 0 9-9 9.75 9.75 0 0 0-6.74 2.74L3 8M3 3v5h5",
  rotateRight: "M21 12a9 9 0 1 1-9-9c2.52 0 4.93 1 6.74 2.74L21 8M21 3v5h-5",
  clock: "M12 2a10 10 0 1 0 0 20 10 10 0 0 0 0-20M12 6v6l4 2",
  stop: "M8 2.5h8L21.5 8v8L16 21.5H8L2.5 16V8zM9 9h6v6H9z",
  hand:
    "M18 11V6a2 2 0 0 0-4 0m0 4V4a2 2 0 0 0-4 0v6m0 .5V6a2 2 0 0 0-4 0v8" +
    "M18 8a2 2 0 1 1 4 0v6a8 8 0 0 1-8 8h-2c-2.8 0-4.5-.86-5.99-2.34l-3.6-3.6a2 2 0 0 1 2.83-2.82L7 15",
  pencil:
    "M21.17 6.81a1 1 0 0 0-3.98-3.98L3.84 16.17a2 2 0 0 0-.5.83l-1.32 4.35a.5.5 0 0 0 .62.62l4.35-1.32a2 2 0 0 0 .83-.5z",
  split: "M16 3h5v5M8 3H3v5m9 14v-8.3a4 4 0 0 0-1.17-2.87L3 3m12 6 6-6",
  repeat: "m17 2 4 4-4 4M3 11v-1a4 4 0 0 1 4-4h14M7 22l-4-4 4-4m14-1v1a4 4 0 0 1-4 4H3",
  none: "",
} as const;

export type IconName = keyof typeof SHAPES;

export function iconShape(name: IconName): string {
  return SHAPES[name];
}

/** The icon as an image of its own: Blockly takes pictures by address only, and nothing may come from elsewhere. */
export function iconSource(name: IconName): string {
  const svg =
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24" fill="none" stroke="#fff" stroke-width="2.5"' +
    ` stroke-linecap="round" stroke-linejoin="round"><path d="${SHAPES[name]}"/></svg>`;
  return `data:image/svg+xml,${encodeURIComponent(svg)}`;
}

/** The leading picture of a block, as an argument of its definition. */
export function iconArgument(name: IconName) {
  return {
    type: "field_icon",
    name: "ICON",
    src: iconSource(name),
    width: 24,
    height: 24,
    alt: "",
  };
}

/** Keeps a word that stands alone in its row clear of the notch above it and in line with the words over it. */
export const rowSpacer = { ...iconArgument("none"), name: "SPACER", height: 36 };
