import uPlot from "uplot";
import { CATEGORY_COLOURS } from "../blocks/categories";
import { categoryOf } from "../blocks/definitions";
import { coarse, type Stretch } from "../run/playback";
import { rowAt, type Samples } from "../run/samples";
import {
  type Chart,
  type ChartOptions,
  listen,
  NO_DATA,
  optionsFor,
  type PlotInput,
} from "./chart";
import { DASHES, type PlotStyle, WIDTHS } from "./plot_style";
import { linesOf, type PlotLine, type PlotName, rangeOf, TIME_PLOTS, times } from "./plots";

/**
 * Height in pixels of the coloured band that shows the blocks, and opacity of the tint above it.
 */
const BAND = 7;
const TINT = 0.1;

/** Minimum length of the time axis, in seconds. */
const MIN_SPAN_S = 2;

type TimePlotName = Exclude<PlotName, "path">;

/** Chart of quantities over time, with the running blocks as a coloured band. */
export class TimeChart implements Chart {
  readonly plot: uPlot;
  private lines: readonly PlotLine[] = [];
  private stretches: readonly Stretch[] = [];
  private ticks: Float32Array = new Float32Array(0);
  private selectedTick: number | null = null;

  constructor(
    private readonly name: TimePlotName,
    chartOptions: ChartOptions,
    into: HTMLElement,
    input: PlotInput,
  ) {
    const { span } = TIME_PLOTS[name];
    const { style } = chartOptions;
    const options = optionsFor(chartOptions);
    options.scales = {
      x: { time: false, range: (_plot, _low, high) => [0, Math.max(MIN_SPAN_S, high ?? 0)] },
      y: { range: (_plot, low, high) => rangeOf(low, high, span) },
    };
    options.cursor = {
      ...options.cursor,
      points: { size: 9, width: 2, fill: (_plot, at) => this.inkOf(at, style) },
    };
    options.hooks = {
      drawClear: [(plot) => drawBands(plot, this.stretches, TINT, 0)],
      draw: [
        (plot) => drawBands(plot, this.stretches, 1, BAND),
        (plot) => drawLetters(plot, this.lines, style),
      ],
    };
    this.style = style;
    this.plot = new uPlot(options, NO_DATA, into);
    listen(this.plot, (x) => this.tickAt(x), input);
  }

  private readonly style: PlotStyle;

  show(samples: Samples, stretches: readonly Stretch[]): void {
    const { plot } = this;
    this.stretches = coarse(stretches, samples.column("tick").at(-1) ?? 0);
    this.ticks = samples.column("tick");
    this.setLines(linesOf(this.name, samples));
    const data = [times(samples), ...this.lines.map((line) => line.values(samples))];
    plot.setData(data as unknown as uPlot.AlignedData);
    this.selectTick(this.selectedTick);
  }

  resize(width: number, height: number): void {
    this.plot.setSize({ width, height });
    this.selectTick(this.selectedTick);
  }

  selectTick(tick: number | null): void {
    this.selectedTick = tick;
    const left = tick === null ? -10 : this.plot.valToPos(tick / 30, "x");
    this.plot.setCursor({ left, top: tick === null ? -10 : 0 }, false);
  }

  dispose(): void {
    this.plot.destroy();
  }

  private tickAt(x: number): number {
    const tick = this.plot.posToVal(x, "x") * 30;
    return this.ticks[rowAt(this.ticks, Math.max(0, tick))] ?? 0;
  }

  /** Rebuilds the series if their number changed, for instance when the true pose becomes known. */
  private setLines(lines: readonly PlotLine[]): void {
    const same = lines.length === this.lines.length;
    this.lines = lines;
    if (same) return;
    while (this.plot.series.length > 1) this.plot.delSeries(1);
    for (const line of lines) this.plot.addSeries(seriesOf(line, this.style));
  }

  private inkOf(series: number, style: PlotStyle): string {
    return style[this.lines[series - 1]?.ink ?? "only"];
  }
}

function seriesOf({ ink, role }: PlotLine, style: PlotStyle): uPlot.Series {
  return {
    stroke: style[ink],
    width: WIDTHS[role],
    dash: [...DASHES[role]],
    points: { show: false },
  };
}

/** Draws the categories of the blocks along the time axis; `height` 0 fills the plot. */
function drawBands(
  plot: uPlot,
  stretches: readonly Stretch[],
  opacity: number,
  height: number,
): void {
  const { ctx } = plot;
  const { left, top, width, height: whole } = plot.bbox;
  const tall = height === 0 ? whole : height * uPlot.pxRatio;
  ctx.save();
  ctx.beginPath();
  ctx.rect(left, top, width, whole);
  ctx.clip();
  ctx.globalAlpha = opacity;
  for (const { from, to, action } of stretches) {
    const begin = plot.valToPos(from / 30, "x", true);
    const end = plot.valToPos(to / 30, "x", true);
    ctx.fillStyle = CATEGORY_COLOURS[categoryOf(action)];
    ctx.fillRect(begin, top + whole - tall, Math.max(1, end - begin - 1), tall);
  }
  ctx.restore();
}

/** Draws the letter of each quantity at its line's end: colour alone must not distinguish lines. */
function drawLetters(plot: uPlot, lines: readonly PlotLine[], style: PlotStyle): void {
  const { ctx } = plot;
  const last = plot.data[0].length - 1;
  const time = plot.data[0][last];
  if (time === undefined) return;
  ctx.save();
  ctx.font = `700 ${14 * uPlot.pxRatio}px ${style.font}`;
  ctx.textBaseline = "middle";
  ctx.textAlign = "left";
  const placed: number[] = [];
  lines.forEach(({ letter, role, ink }, index) => {
    const value = plot.data[index + 1]?.[last];
    if (value == null || role === "desired" || role === "commanded" || role === "true") return;
    const height = 15 * uPlot.pxRatio;
    let y = plot.valToPos(value, "y", true);
    while (placed.some((other) => Math.abs(other - y) < height)) y -= height / 2;
    placed.push(y);
    ctx.fillStyle = style[ink];
    ctx.fillText(letter, plot.valToPos(time, "x", true) + 6 * uPlot.pxRatio, y);
  });
  ctx.restore();
}
