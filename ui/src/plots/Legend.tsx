import { BLOCK_TEXTS } from "../blocks/texts";
import { CATEGORY_COLOURS, categoryOf } from "../design/categories";
import { type Language, language, type Texts, texts } from "../i18n";
import { decimal, seconds } from "../i18n/format";
import { type Column, rowAt, type Samples } from "../run/samples";
import { type FigureName, linesOf, type Role, TIME_FIGURES } from "./figures";
import { DASHES, type Look, WIDTHS } from "./look";
import type { PlotSource } from "./PlotsPanel";
import { pathRoles } from "./path_chart";

/** One line of a plot in words. */
export interface Entry {
  readonly role: Role;
  readonly ink: keyof Pick<Look, "x" | "y" | "only" | "soft">;
  readonly name: string;
  /** What it is worth at a row, with its unit. */
  valueAt(row: number): string;
}

/** What the lines of a plot are, as its legend has them. */
export function entriesOf(
  figure: FigureName,
  samples: Samples,
  { plots }: Texts,
  language: Language,
): Entry[] {
  if (figure === "path") {
    return pathRoles(samples).map((role) => ({
      role,
      ink: role === "desired" ? "soft" : "only",
      name: plots.roles[role],
      valueAt: (row) => placeAt(samples, role, row, language),
    }));
  }
  const { unit } = TIME_FIGURES[figure];
  const digits = unit === "m" || unit === "m/s" ? 2 : 1;
  return linesOf(figure, samples).map(({ letter, role, ink, values }) => ({
    role,
    ink,
    name: `${letter} ${plots.roles[role]}`,
    valueAt: (row) => {
      const value = decimal(values(samples)[row] ?? 0, digits, language);
      return `${value}${unit === "°" ? "" : "\u00a0"}${unit}`;
    },
  }));
}

const PLACES: Partial<Record<Role, readonly [Column, Column]>> = {
  obtained: ["x_m", "y_m"],
  desired: ["goal_x_m", "goal_y_m"],
  true: ["true_x_m", "true_y_m"],
};

function placeAt(samples: Samples, role: Role, row: number, language: Language): string {
  const [x, y] = (PLACES[role] ?? ["x_m", "y_m"]).map((name) =>
    decimal(samples.column(name)[row] ?? 0, 2, language),
  );
  return `(${x}; ${y}) m`;
}

interface LegendProps {
  source: PlotSource;
  figure: FigureName;
}

/** The lines of a plot by name, each drawn as in the plot, and what they are worth at the moment looked at. */
export function Legend({ source, figure }: LegendProps) {
  const { samples } = source;
  const moment = source.moment.value;
  const row = moment === null ? samples.rows - 1 : rowAt(samples.column("tick"), moment);
  const tick = samples.column("tick")[row] ?? 0;
  return (
    <div class="plots__legend">
      <span class="plots__line">{seconds(tick / 30, language.value)}</span>
      {entriesOf(figure, samples, texts.value, language.value).map(
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
      {figure !== "path" && <Block source={source} tick={tick} />}
    </div>
  );
}

/** Of which category the block is that ran then. */
function Block({ source, tick }: { source: PlotSource; tick: number }) {
  const stretch = source.stretches.findLast(({ from, to }) => from <= tick && tick <= to);
  if (!stretch) return null;
  const category = categoryOf(stretch.action);
  return (
    <span class="plots__line">
      <span class="plots__block" style={{ background: CATEGORY_COLOURS[category] }} />
      {categoryWords(category, language.value)}
    </span>
  );
}

export function categoryWords(category: keyof typeof CATEGORY_COLOURS, now: Language): string {
  const key = `CATEGORY_${category.toUpperCase()}` as keyof (typeof BLOCK_TEXTS)["pt-BR"];
  return BLOCK_TEXTS[now][key];
}
