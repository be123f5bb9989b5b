import type uPlot from "uplot";
import type { Language } from "../i18n";
import { decimal } from "../i18n/format";
import type { Stretch } from "../run/playback";
import type { Samples } from "../run/samples";
import type { PlotStyle } from "./plot_style";

/** Callbacks of a plot's pointer and keyboard input; `null` if the pointer has left the plot. */
export interface PlotInput {
  onPoint(tick: number | null): void;
  onPress(tick: number): void;
}

/** Appearance and size of a plot. */
export interface ChartOptions {
  readonly style: PlotStyle;
  readonly language: Language;
  readonly width: number;
  readonly height: number;
  /** Titles of the x and y axes. */
  readonly titles: readonly [string, string];
}

/** A plot that is mounted in the page. */
export interface Chart {
  readonly plot: uPlot;
  show(samples: Samples, stretches: readonly Stretch[]): void;
  resize(width: number, height: number): void;
  /** Marks a tick. */
  selectTick(tick: number | null): void;
  dispose(): void;
}

/** Space for the numbers beside and below a plot, and padding at the other sides, in pixels. */
export const AXIS = { left: 58, bottom: 44 };
export const PADDING = { top: 10, right: 26 };

/** uPlot's own mouse handling is off, because touch and keys also select a tick. */
const nobody = () => null;
const NO_MOUSE: uPlot.Cursor.Bind = {
  mousedown: nobody,
  mouseup: nobody,
  click: nobody,
  dblclick: nobody,
  mousemove: nobody,
  mouseleave: nobody,
  mouseenter: nobody,
};

export const NO_DATA: uPlot.AlignedData = [[0, 1]];

/** uPlot options that all plots share. */
export function optionsFor({
  style,
  language,
  width,
  height,
  titles,
}: ChartOptions): uPlot.Options {
  const axis = (title: string, size: number): uPlot.Axis => ({
    label: title,
    labelFont: `600 13px ${style.font}`,
    labelSize: 18,
    labelGap: 0,
    font: `500 13px ${style.font}`,
    gap: 4,
    size: size - 18,
    stroke: style.ink,
    grid: { stroke: style.faint, width: 1 },
    ticks: { show: false },
    values: (_plot, splits) => splits.map((value) => numberOf(value, splits, language)),
  });
  const upright = axis(titles[1], AXIS.left);
  return {
    width,
    height,
    padding: [PADDING.top, PADDING.right, 0, 0],
    legend: { show: false },
    scales: { x: { time: false } },
    axes: [
      { ...axis(titles[0], AXIS.bottom), space: 44 },
      { ...upright, space: 30 },
    ],
    cursor: { y: false, bind: NO_MOUSE, drag: { setScale: false, x: false, y: false } },
    series: [{}],
  };
}

/** Formats an axis value with as many digits as the axis step needs. */
export function numberOf(
  value: number,
  splits: readonly (number | null)[],
  language: Language,
): string {
  const step = Math.abs((splits[1] ?? 1) - (splits[0] ?? 0)) || 1;
  const digits = [0, 1, 2, 3].find((count) => Math.abs(step - round(step, count)) < step / 100);
  return decimal(value, digits ?? 3, language);
}

const round = (value: number, digits: number) => Math.round(value * 10 ** digits) / 10 ** digits;

/**
 * Handles mouse, pen and touch on a plot: moving points at a tick, pressing or dragging selects it.
 */
export function listen(plot: uPlot, tickAt: (x: number, y: number) => number, input: PlotInput) {
  const { over } = plot;
  let pressed = false;
  const tickOf = (event: PointerEvent) => {
    const box = over.getBoundingClientRect();
    return tickAt(event.clientX - box.left, event.clientY - box.top);
  };
  const move = (event: PointerEvent) => {
    if (pressed) input.onPress(tickOf(event));
    else input.onPoint(tickOf(event));
  };
  const down = (event: PointerEvent) => {
    pressed = true;
    over.setPointerCapture(event.pointerId);
    input.onPress(tickOf(event));
  };
  const up = () => {
    pressed = false;
  };
  const leave = () => input.onPoint(null);
  const listeners = { pointermove: move, pointerdown: down, pointerup: up, pointercancel: up };
  for (const [type, listener] of Object.entries(listeners)) {
    over.addEventListener(type, listener as EventListener);
  }
  over.addEventListener("pointerleave", leave);
}
