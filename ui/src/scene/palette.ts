const TOKENS = {
  outside: "--floor-outside",
  tile: "--floor-tile",
  otherTile: "--floor-tile-other",
  line: "--floor-line",
  number: "--floor-number",
  wall: "--floor-wall",
  box: "--floor-box",
  boxSide: "--floor-box-side",
  start: "--floor-start",
  path: "--floor-path",
  ideal: "--floor-ideal",
  robot: "--robot-body",
  deck: "--robot-deck",
  wheel: "--robot-wheel",
  mark: "--robot-mark",
  shadow: "--robot-shadow",
  markX: "--floor-mark-x",
  markO: "--floor-mark-o",
  font: "--font",
} as const;

export type Palette = Record<keyof typeof TOKENS, string>;

/** The colours of the light floor, whatever the theme: for pictures that leave the program. */
export function paperPalette(): Palette {
  const { dataset } = document.documentElement;
  const now = dataset.theme;
  dataset.theme = "light";
  const palette = readPalette();
  dataset.theme = now;
  return palette;
}

/** The colours of the floor in the theme that is on: a canvas cannot read the page's tokens itself. */
export function readPalette(): Palette {
  const style = getComputedStyle(document.documentElement);
  return Object.fromEntries(
    Object.entries(TOKENS).map(([name, token]) => [name, style.getPropertyValue(token).trim()]),
  ) as Palette;
}
