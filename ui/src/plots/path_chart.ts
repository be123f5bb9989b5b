import uPlot from "uplot";
import { rowAt, Samples } from "../run/samples";
import {
  type Chart,
  type ChartOptions,
  listen,
  NO_DATA,
  optionsFor,
  type PlotInput,
} from "./chart";
import { DASHES, type PlotStyle, WIDTHS } from "./plot_style";
import { equalRange, hasTruth, nearestRow, type Range, type Role } from "./plots";

type Columns = readonly [x: Float32Array, y: Float32Array];

interface PathLine {
  readonly role: Role;
  readonly ink: keyof Pick<PlotStyle, "only" | "soft">;
  readonly points: Columns;
}

/** The robot's path on the floor, with the same scale in both directions. */
export class PathChart implements Chart {
  readonly plot: uPlot;
  private samples = new Samples();
  private range: Range = { x: [-1, 1], y: [-1, 1] };
  private selectedTick: number | null = null;
  private readonly here = document.createElement("div");

  constructor(chartOptions: ChartOptions, into: HTMLElement, input: PlotInput) {
    const options = optionsFor(chartOptions);
    options.scales = {
      x: { time: false, range: () => this.range.x },
      y: { range: () => this.range.y },
    };
    options.cursor = { ...options.cursor, show: false };
    options.series = [{}, { show: true, points: { show: false } }];
    options.hooks = { draw: [(plot) => this.draw(plot, chartOptions.style)] };
    this.plot = new uPlot(options, [...NO_DATA, [0, 1]] as uPlot.AlignedData, into);
    this.here.className = "plots__here";
    this.here.hidden = true;
    this.plot.over.append(this.here);
    listen(this.plot, (x, y) => this.tickAt(x, y), input);
  }

  show(samples: Samples): void {
    this.samples = samples;
    this.aim();
  }

  resize(width: number, height: number): void {
    this.plot.setSize({ width, height });
    this.aim();
  }

  selectTick(tick: number | null): void {
    this.selectedTick = tick;
    const { samples, plot, here } = this;
    here.hidden = tick === null || samples.rows === 0;
    if (here.hidden || tick === null) return;
    const row = rowAt(samples.column("tick"), tick);
    const left = plot.valToPos(samples.column("x_m")[row] ?? 0, "x");
    const top = plot.valToPos(samples.column("y_m")[row] ?? 0, "y");
    here.style.transform = `translate(${left}px, ${top}px)`;
  }

  dispose(): void {
    this.plot.destroy();
  }

  private aim(): void {
    const { width, height } = this.plot.over.getBoundingClientRect();
    const area = width > 1 ? { width, height } : this.drawnArea();
    const points = linesIn(this.samples).map((line) => line.points);
    this.range = equalRange(points, area.width, area.height);
    // setting the data makes uPlot read the range again; the two points are the corners of the
    // range
    this.plot.setData([this.range.x, this.range.y]);
    queueMicrotask(() => this.selectTick(this.selectedTick));
  }

  /** Size of the drawing area in CSS pixels, for a chart outside the page, which has no layout. */
  private drawnArea() {
    const { width, height } = this.plot.bbox;
    return { width: width / uPlot.pxRatio, height: height / uPlot.pxRatio };
  }

  private tickAt(x: number, y: number): number {
    const { samples, plot } = this;
    const [atX, atY] = [plot.posToVal(x, "x"), plot.posToVal(y, "y")];
    const row = nearestRow(samples.column("x_m"), samples.column("y_m"), atX, atY);
    return samples.column("tick")[row] ?? 0;
  }

  private draw(plot: uPlot, style: PlotStyle): void {
    const { ctx } = plot;
    const { left, top, width, height } = plot.bbox;
    ctx.save();
    ctx.beginPath();
    ctx.rect(left, top, width, height);
    ctx.clip();
    ctx.lineJoin = "round";
    for (const { role, ink, points } of linesIn(this.samples)) {
      ctx.strokeStyle = style[ink];
      ctx.lineWidth = (WIDTHS[role] + (role === "obtained" ? 0.5 : 0)) * uPlot.pxRatio;
      ctx.setLineDash(DASHES[role].map((part) => part * uPlot.pxRatio));
      trace(plot, points);
    }
    drawEnds(plot, this.samples, style);
    ctx.restore();
  }
}

/** Dashed lines come last, because they are thin and must be visible on top of others. */
function linesIn(samples: Samples): PathLine[] {
  const pair = (
    x: "x_m" | "goal_x_m" | "true_x_m",
    y: "y_m" | "goal_y_m" | "true_y_m",
  ): Columns => [samples.column(x), samples.column(y)];
  const lines: PathLine[] = [
    { role: "obtained", ink: "only", points: pair("x_m", "y_m") },
    { role: "desired", ink: "soft", points: pair("goal_x_m", "goal_y_m") },
  ];
  if (hasTruth(samples)) {
    lines.push({ role: "true", ink: "only", points: pair("true_x_m", "true_y_m") });
  }
  return lines;
}

function trace(plot: uPlot, [xs, ys]: Columns): void {
  const { ctx } = plot;
  ctx.beginPath();
  let [lastX, lastY] = [Number.NaN, Number.NaN];
  for (let row = 0; row < xs.length; row++) {
    const x = plot.valToPos(xs[row] ?? 0, "x", true);
    const y = plot.valToPos(ys[row] ?? 0, "y", true);
    // skip points that fall on the same pixel
    if (Math.abs(x - lastX) + Math.abs(y - lastY) < 1) continue;
    ctx.lineTo(x, y);
    [lastX, lastY] = [x, y];
  }
  ctx.stroke();
}

/** Draws a ring at the start of the path and a full dot at its end. */
function drawEnds(plot: uPlot, samples: Samples, style: PlotStyle): void {
  const { ctx } = plot;
  const dot = (x: number, y: number) => {
    ctx.beginPath();
    ctx.arc(
      plot.valToPos(x, "x", true),
      plot.valToPos(y, "y", true),
      5 * uPlot.pxRatio,
      0,
      2 * Math.PI,
    );
  };
  ctx.setLineDash([]);
  ctx.lineWidth = 2 * uPlot.pxRatio;
  ctx.strokeStyle = style.soft;
  ctx.fillStyle = style.ground;
  dot(0, 0);
  ctx.fill();
  ctx.stroke();
  const last = samples.rows - 1;
  if (last < 0) return;
  ctx.fillStyle = style.only;
  dot(samples.column("x_m")[last] ?? 0, samples.column("y_m")[last] ?? 0);
  ctx.fill();
}

export const pathRoles = (samples: Samples): Role[] => linesIn(samples).map((line) => line.role);
