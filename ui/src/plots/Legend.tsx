import { CATEGORY_COLOURS } from "../blocks/categories";
import { categoryOf } from "../blocks/definitions";
import type { TextKey } from "../blocks/texts";
import { type Language, language, type Texts, texts, textsOf } from "../i18n";
import { decimal, seconds } from "../i18n/format";
import { type Column, rowAt, type Samples } from "../run/samples";
import { pathRoles } from "./path_chart";
import type { PlotSource } from "./plot_source";
import { DASHES, type PlotStyle, WIDTHS } from "./plot_style";
import { linesOf, type PlotName, type Role, TIME_PLOTS } from "./plots";

/** A legend entry: one line of a plot in words. */
export interface LegendEntry {
  readonly role: Role;
  readonly ink: keyof Pick<PlotStyle, "x" | "y" | "only" | "soft">;
  readonly name: string;
  /** Its value at a row, with the unit. */
  valueAt(row: number): string;
}

/** The legend entries of a plot. */
export function entriesOf(
  plotName: PlotName,
  samples: Samples,
  { plots }: Texts,
  language: Language,
): LegendEntry[] {
  if (plotName === "path") {
    return pathRoles(samples).map((role) => ({
      role,
      ink: role === "desired" ? "soft" : "only",
      name: plots.roles[role],
      valueAt: (row) => positionAt(samples, role, row, language),
    }));
  }
  const { unit } = TIME_PLOTS[plotName];
  const digits = unit === "m" || unit === "m/s" ? 2 : 1;
  return linesOf(plotName, samples).map(({ letter, role, ink, values }) => ({
    role,
    ink,
    name: `${letter} ${plots.roles[role]}`,
    valueAt: (row) => {
      const value = decimal(values(samples)[row] ?? 0, digits, language);
      return `${value}${unit === "°" ? "" : "\u00a0"}${unit}`;
    },
  }));
}

const POSITION_COLUMNS: Partial<Record<Role, readonly [Column, Column]>> = {
  obtained: ["x_m", "y_m"],
  desired: ["goal_x_m", "goal_y_m"],
  true: ["true_x_m", "true_y_m"],
};

function positionAt(samples: Samples, role: Role, row: number, language: Language): string {
  const [x, y] = (POSITION_COLUMNS[role] ?? ["x_m", "y_m"]).map((name) =>
    decimal(samples.column(name)[row] ?? 0, 2, language),
  );
  return `(${x}; ${y}) m`;
}

interface LegendProps {
  source: PlotSource;
  plotName: PlotName;
}

/** The lines of a plot by name, each with its line style and its value at the selected tick. */
export function Legend({ source, plotName }: LegendProps) {
  const { samples } = source;
  const selectedTick = source.selectedTick.value;
  const row =
    selectedTick === null ? samples.rows - 1 : rowAt(samples.column("tick"), selectedTick);
  const tick = samples.column("tick")[row] ?? 0;
  return (
    <div class="plots__legend">
      <span class="plots__line">{seconds(tick / 30, language.value)}</span>
      {entriesOf(plotName, samples, texts.value, language.value).map(
        ({ role, ink, name, valueAt }) => (
          <span class="plots__line" key={name}>
            <svg class="plots__swatch" aria-hidden="true">
              <line
                x1="0"
                x2="30"
                y1="5"
                y2="5"
                stroke={`var(--plot-${ink})`}
                stroke-width={WIDTHS[role]}
                stroke-dasharray={DASHES[role].join(" ")}
              />
            </svg>
            {name}
            <span class="plots__value">{valueAt(row)}</span>
          </span>
        ),
      )}
      {plotName !== "path" && <Block source={source} tick={tick} />}
    </div>
  );
}

/** The category of the block that ran at a tick. */
function Block({ source, tick }: { source: PlotSource; tick: number }) {
  const stretch = source.stretches.findLast(({ from, to }) => from <= tick && tick <= to);
  if (!stretch) return null;
  const category = categoryOf(stretch.action);
  return (
    <span class="plots__line">
      <span class="plots__block" style={{ background: CATEGORY_COLOURS[category] }} />
      {categoryLabel(category, language.value)}
    </span>
  );
}

export function categoryLabel(category: keyof typeof CATEGORY_COLOURS, now: Language): string {
  const key = `CATEGORY_${category.toUpperCase()}` as TextKey;
  return textsOf(now).blocks[key];
}
