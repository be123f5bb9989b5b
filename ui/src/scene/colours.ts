const TOKENS = {
  outside: "--floor-outside",
  tile: "--floor-tile",
  otherTile: "--floor-tile-other",
  line: "--floor-line",
  number: "--floor-number",
  ink: "--ink",
  wall: "--floor-wall",
  box: "--floor-box",
  boxSide: "--floor-box-side",
  start: "--floor-start",
  path: "--floor-path",
  ideal: "--floor-ideal",
  measured: "--floor-measured",
  robot: "--robot-body",
  deck: "--robot-deck",
  wheel: "--robot-wheel",
  mark: "--robot-mark",
  shadow: "--robot-shadow",
  print: "--floor-print",
  markX: "--floor-mark-x",
  markO: "--floor-mark-o",
  font: "--font",
} as const;

/** Colours of the floor by their role. */
export type Colours = Record<keyof typeof TOKENS, string>;

/** Colours of the light theme in any current theme, for exported pictures. */
export function paperColours(): Colours {
  const { dataset } = document.documentElement;
  const now = dataset.theme;
  dataset.theme = "light";
  const colours = readColours();
  dataset.theme = now;
  return colours;
}

/** Colours of the current theme: a canvas cannot use CSS variables. */
export function readColours(): Colours {
  const style = getComputedStyle(document.documentElement);
  return Object.fromEntries(
    Object.entries(TOKENS).map(([name, token]) => [name, style.getPropertyValue(token).trim()]),
  ) as Colours;
}
