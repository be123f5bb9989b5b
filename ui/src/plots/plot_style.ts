/** The colours of a plot: a canvas cannot use CSS variables. */
export interface PlotStyle {
  readonly ground: string;
  readonly ink: string;
  readonly faint: string;
  readonly x: string;
  readonly y: string;
  readonly only: string;
  readonly soft: string;
  readonly font: string;
}

const TOKENS: Readonly<Record<keyof PlotStyle, string>> = {
  ground: "--surface",
  ink: "--ink",
  faint: "--line",
  x: "--plot-x",
  y: "--plot-y",
  only: "--plot-only",
  soft: "--plot-soft",
  font: "--font",
};

/** Colours of the current theme. */
export function currentStyle(): PlotStyle {
  const style = getComputedStyle(document.documentElement);
  const value = (token: string) => style.getPropertyValue(token).trim();
  const entries = Object.entries(TOKENS).map(([name, token]) => [name, value(token)]);
  return Object.fromEntries(entries) as unknown as PlotStyle;
}

/** Dark lines on white, whatever the theme: for exported pictures. */
export function paperStyle(): PlotStyle {
  return {
    ground: "#ffffff",
    ink: "#211f1b",
    faint: "#dcd6ca",
    x: "#1d5fb8",
    y: "#b04a00",
    only: "#0a7a60",
    soft: "#3c372d",
    font: currentStyle().font,
  };
}

/**
 * Dash patterns: desired and commanded values are dashed, true ones dotted, obtained ones solid.
 */
export const DASHES = {
  obtained: [],
  measured: [],
  desired: [7, 5],
  commanded: [7, 5],
  true: [2, 4],
} as const satisfies Record<string, readonly number[]>;

export const WIDTHS = {
  obtained: 2.5,
  measured: 2.5,
  desired: 2,
  commanded: 2,
  true: 2.5,
} as const;
