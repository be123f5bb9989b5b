import type { Column, Samples } from "../run/samples";

/** The plots of a run, as in the report of an experiment. */
export const PLOTS = ["path", "position", "heading", "speed", "turning"] as const;

export type PlotName = (typeof PLOTS)[number];

/**
 * Source of a line: the estimated pose, the desired pose, the true pose, the command, or a
 * measurement.
 */
export type Role = "obtained" | "desired" | "true" | "commanded" | "measured";

export interface PlotLine {
  /** Key of the line's colour. */
  readonly ink: "x" | "y" | "only" | "soft";
  /** Letter of the quantity. */
  readonly letter: string;
  readonly role: Role;
  values(samples: Samples): ArrayLike<number>;
}

export interface TimePlot {
  readonly unit: "m" | "°" | "m/s" | "°/s";
  readonly lines: readonly PlotLine[];
  /** Minimum span of the vertical axis, so that noise does not look like motion. */
  readonly span: number;
}

const TRUE_OFF_M = 1e-3;

const plain = (name: Column) => (samples: Samples) => samples.column(name);

const inDegrees = (name: Column) => (samples: Samples) =>
  samples.column(name).map((value) => (value * 180) / Math.PI);

const position = (letter: "x" | "y"): PlotLine[] => [
  { ink: letter, letter, role: "obtained", values: plain(`${letter}_m`) },
  { ink: letter, letter, role: "desired", values: plain(`goal_${letter}_m`) },
  { ink: letter, letter, role: "true", values: plain(`true_${letter}_m`) },
];

export const TIME_PLOTS: Readonly<Record<Exclude<PlotName, "path">, TimePlot>> = {
  position: { unit: "m", span: 0.2, lines: [...position("x"), ...position("y")] },
  heading: {
    unit: "°",
    span: 20,
    lines: [
      { ink: "only", letter: "θ", role: "obtained", values: (samples) => headings(samples) },
      { ink: "soft", letter: "θ", role: "desired", values: near("goal_yaw_rad") },
      { ink: "only", letter: "θ", role: "true", values: near("true_yaw_rad") },
    ],
  },
  speed: {
    unit: "m/s",
    span: 0.1,
    lines: [
      { ink: "only", letter: "v", role: "measured", values: plain("v_mps") },
      { ink: "soft", letter: "v", role: "commanded", values: plain("command_v_mps") },
    ],
  },
  turning: {
    unit: "°/s",
    span: 10,
    lines: [
      { ink: "only", letter: "ω", role: "measured", values: inDegrees("omega_radps") },
      { ink: "soft", letter: "ω", role: "commanded", values: inDegrees("command_omega_radps") },
    ],
  },
};

/**
 * The lines of a plot. The true pose is included only if it is known and differs from the estimated
 * one.
 */
export function linesOf(name: Exclude<PlotName, "path">, samples: Samples): readonly PlotLine[] {
  const withTruth = hasTruth(samples);
  return TIME_PLOTS[name].lines.filter((line) => line.role !== "true" || withTruth);
}

export function hasTruth(samples: Samples): boolean {
  const [x, y] = [samples.column("x_m"), samples.column("y_m")];
  const [trueX, trueY] = [samples.column("true_x_m"), samples.column("true_y_m")];
  return trueX.some((value, row) => {
    return Math.hypot(value - (x[row] ?? 0), (trueY[row] ?? 0) - (y[row] ?? 0)) > TRUE_OFF_M;
  });
}

/** Headings in degrees, unwrapped: they continue past 180 instead of jumping to -180. */
export function headings(samples: Samples): Float64Array {
  const yaws = samples.column("yaw_rad");
  const turned = new Float64Array(yaws.length);
  let before = 0;
  yaws.forEach((yaw, row) => {
    before += wrapped(yaw - before);
    turned[row] = (before * 180) / Math.PI;
  });
  return turned;
}

/** Another heading, unwrapped to within half a turn of the estimated one. */
function near(name: Column): (samples: Samples) => Float64Array {
  return (samples) => {
    const own = headings(samples);
    const yaws = samples.column("yaw_rad");
    const others = samples.column(name);
    return own.map((heading, row) => {
      const off = wrapped((others[row] ?? Number.NaN) - (yaws[row] ?? 0));
      return heading + (off * 180) / Math.PI;
    });
  };
}

const wrapped = (angle: number) => Math.atan2(Math.sin(angle), Math.cos(angle));

/** Time of each sample in seconds. */
export const times = (samples: Samples): Float64Array =>
  Float64Array.from(samples.column("tick"), (tick) => tick / 30);

/** Range of the vertical axis: all values with a margin, and at least `span`. */
export function rangeOf(low: number | null, high: number | null, span: number): [number, number] {
  if (low === null || high === null) return [-span / 2, span / 2];
  const half = Math.max(span, (high - low) * 1.3) / 2;
  const middle = (low + high) / 2;
  return [middle - half, middle + half];
}

export interface Range {
  readonly x: [number, number];
  readonly y: [number, number];
}

const MIN_RANGE_M = 1;
const AIR = 1.12;

/** Axis ranges with the same scale in both directions, around all points. */
export function equalRange(
  lines: readonly (readonly [ArrayLike<number>, ArrayLike<number>])[],
  width: number,
  height: number,
): Range {
  const [left, right] = extent(lines.map(([xs]) => xs));
  const [bottom, top] = extent(lines.map(([, ys]) => ys));
  const metre = Math.min(
    width / Math.max(MIN_RANGE_M, (right - left) * AIR),
    height / Math.max(MIN_RANGE_M, (top - bottom) * AIR),
  );
  const around = (low: number, high: number, pixels: number): [number, number] => {
    const half = pixels / metre / 2;
    return [(low + high) / 2 - half, (low + high) / 2 + half];
  };
  return { x: around(left, right, width), y: around(bottom, top, height) };
}

function extent(columns: readonly ArrayLike<number>[]): [number, number] {
  let [low, high] = [0, 0];
  for (const column of columns) {
    for (let row = 0; row < column.length; row++) {
      const value = column[row] ?? 0;
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  return [low, high];
}

/** The row whose point is nearest to (x, y); both in pixels or both in metres. */
export function nearestRow(
  xs: ArrayLike<number>,
  ys: ArrayLike<number>,
  x: number,
  y: number,
): number {
  let [best, minSquared] = [0, Number.POSITIVE_INFINITY];
  for (let row = 0; row < xs.length; row++) {
    const far = ((xs[row] ?? 0) - x) ** 2 + ((ys[row] ?? 0) - y) ** 2;
    if (far < minSquared) [best, minSquared] = [row, far];
  }
  return best;
}
