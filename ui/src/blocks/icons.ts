/** Path data of lucide icons (ISC licence), 24 x 24, drawn as strokes. */
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
  spline:
    "M17 5a2 2 0 1 0 4 0 2 2 0 1 0-4 0M3 19a2 2 0 1 0 4 0 2 2 0 1 0-4 0M5 17A12 12 0 0 1 17 5",
  mapPin:
    "M20 10c0 5-5.54 10.19-7.4 11.8a1 1 0 0 1-1.2 0C9.54 20.19 4 15 4 10a8 8 0 0 1 16 0" +
    "M9 10a3 3 0 1 0 6 0 3 3 0 1 0-6 0",
  gauge: "m12 14 4-4M3.34 19a10 10 0 1 1 17.32 0",
  chevronsUp: "m17 11-5-5-5 5M17 18l-5-5-5 5",
  hourglass:
    "M5 22h14M5 2h14M17 22v-4.17a2 2 0 0 0-.59-1.42L12 12l-4.41 4.41A2 2 0 0 0 7 17.83V22" +
    "M7 2v4.17a2 2 0 0 0 .59 1.42L12 12l4.41-4.41A2 2 0 0 0 17 6.17V2",
  infinity: "M6 16c5 0 7-8 12-8a4 4 0 0 1 0 8c-5 0-7-8-12-8a4 4 0 1 0 0 8",
  refresh:
    "M3 12a9 9 0 0 1 9-9 9.75 9.75 0 0 1 6.74 2.74L21 8M21 3v5h-5" +
    "M21 12a9 9 0 0 1-9 9 9.75 9.75 0 0 1-6.74-2.74L3 16M8 16H3v5",
  hash: "M4 9h16M4 15h16M10 3 8 21M16 3l-2 18",
  logOut: "m16 17 5-5-5-5M21 12H9M9 21H5a2 2 0 0 1-2-2V5a2 2 0 0 1 2-2h4",
  skip: "M21 4v16M6.03 4.29A2 2 0 0 0 3 6v12a2 2 0 0 0 3.03 1.72l10-6a2 2 0 0 0 0-3.44z",
  message:
    "M2.99 16.34a2 2 0 0 1 .1 1.17l-1.07 3.29a1 1 0 0 0 1.24 1.17l3.41-1a2 2 0 0 1 1.1.09 10 10 0 1 0-4.78-4.72",
  crosshair: "M2 12a10 10 0 1 0 20 0 10 10 0 1 0-20 0M22 12h-4M6 12H2M12 6V2M12 22v-4",
  penDown:
    "M13 21h8M21.17 6.81a1 1 0 0 0-3.98-3.99L3.84 16.17a2 2 0 0 0-.5.83l-1.32 4.35" +
    "a.5.5 0 0 0 .62.62l4.35-1.32a2 2 0 0 0 .83-.5z",
  penUp:
    "m10 10-6.16 6.16a2 2 0 0 0-.5.83l-1.32 4.36a.5.5 0 0 0 .62.63l4.36-1.33a2 2 0 0 0 .83-.5L14 13.98" +
    "M12.83 7.17l4.36-4.34a1 1 0 1 1 3.99 3.98l-4.36 4.36M2 2l20 20",
  volume:
    "M11 4.7a.7.7 0 0 0-1.2-.5L6.41 7.59A1.4 1.4 0 0 1 5.42 8H3a1 1 0 0 0-1 1v6a1 1 0 0 0 1 1h2.42" +
    "a1.4 1.4 0 0 1 .99.41l3.39 3.39a.7.7 0 0 0 1.2-.5zM16 9a5 5 0 0 1 0 6M19.36 18.36a9 9 0 0 0 0-12.72",
  question: "M2 12a10 10 0 1 0 20 0 10 10 0 1 0-20 0M9.09 9a3 3 0 0 1 5.83 1c0 2-3 3-3 3M12 17h.01",
  box:
    "M21 8a2 2 0 0 0-1-1.73l-7-4a2 2 0 0 0-2 0l-7 4A2 2 0 0 0 3 8v8a2 2 0 0 0 1 1.73l7 4a2 2 0 0 0 2 0" +
    "l7-4A2 2 0 0 0 21 16zM3.3 7l8.7 5 8.7-5M12 22V12",
  diff: "M12 3v14M5 10h14M5 21h14",
  list: "M3 5h.01M3 12h.01M3 19h.01M8 5h13M8 12h13M8 19h13",
  listPlus: "M16 5H3M11 12H3M16 19H3M18 9v6M21 12h-6",
  replace:
    "M14 4a2 2 0 0 1 2-2h4a2 2 0 0 1 2 2v4a2 2 0 0 1-2 2M2 14h8v8H2zM6 10V8a4 4 0 0 1 4-4h2M9 7l3-3-3-3",
  puzzle:
    "M15.39 4.39a1 1 0 0 0 1.68-.47 2.5 2.5 0 1 1 3.01 3.01 1 1 0 0 0-.47 1.68l1.68 1.69a2.41 2.41 0 0 1 0 3.41" +
    "L19.61 15.39a1 1 0 0 1-1.68-.47 2.5 2.5 0 1 0-3.01 3.01 1 1 0 0 1 .47 1.68l-1.68 1.69a2.41 2.41 0 0 1-3.42 0" +
    "L8.61 19.61a1 1 0 0 0-1.68.47 2.5 2.5 0 1 1-3.01-3.01 1 1 0 0 0 .47-1.68L2.71 13.7a2.41 2.41 0 0 1 0-3.41" +
    "L4.39 8.61a1 1 0 0 1 1.68.47 2.5 2.5 0 1 0 3.01-3.01 1 1 0 0 1-.47-1.68l1.69-1.69a2.41 2.41 0 0 1 3.41 0z",
  corner: "M20 4v7a4 4 0 0 1-4 4H4M9 10l-5 5 5 5",
  eye:
    "M2.06 12.35a1 1 0 0 1 0-.7 10.75 10.75 0 0 1 19.88 0 1 1 0 0 1 0 .7 10.75 10.75 0 0 1-19.88 0" +
    "M9 12a3 3 0 1 0 6 0 3 3 0 1 0-6 0",
  calculator:
    "M6 2h12a2 2 0 0 1 2 2v16a2 2 0 0 1-2 2H6a2 2 0 0 1-2-2V4a2 2 0 0 1 2-2M8 6h8M16 14v4" +
    "M16 10h.01M12 10h.01M8 10h.01M12 14h.01M8 14h.01M12 18h.01M8 18h.01",
  type: "M12 4v16M4 7V5a1 1 0 0 1 1-1h14a1 1 0 0 1 1 1v2M9 20h6",
  search: "m21 21-4.34-4.34M3 11a8 8 0 1 0 16 0 8 8 0 1 0-16 0",
  plus: "M2 12a10 10 0 1 0 20 0 10 10 0 1 0-20 0M8 12h8M12 8v8",
  minus: "M2 12a10 10 0 1 0 20 0 10 10 0 1 0-20 0M8 12h8",
  none: "",
} as const;

export type IconName = keyof typeof SHAPES;

export function iconShape(name: IconName): string {
  return SHAPES[name];
}

/**
 * The icon as a data URL: Blockly takes pictures by address only, and the page may not load from
 * the internet.
 */
export function iconSource(name: IconName): string {
  const svg =
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24" fill="none" stroke="#fff" stroke-width="2.5"' +
    ` stroke-linecap="round" stroke-linejoin="round"><path d="${SHAPES[name]}"/></svg>`;
  return `data:image/svg+xml,${encodeURIComponent(svg)}`;
}

/** The icon at the start of a block, as an argument of its definition. */
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

/**
 * Spacer for a row with a single word. It keeps the word clear of the notch above, and aligned with
 * the words of the other rows.
 */
export const rowSpacer = { ...iconArgument("none"), name: "SPACER", height: 36 };
