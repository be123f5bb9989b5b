import { Axis, type Span, spansOf } from "./axis";
import { type LineLayout, layOut, momentsOf } from "./line_layout";
import type { GroupReview } from "./model";
import { type Stretched, stretch } from "./stretch";

/** Whose time the lines show: each group's own, or the clock on the wall. */
export type TimeOf = "group" | "clock";

export interface GroupLine {
  readonly layout: LineLayout;
  /** Where the ruler counts from, seconds; null for the time on the wall. */
  readonly zero: number | null;
}

/** A line is at least so long, for the marks of two minutes not to be strewn over a metre. Seconds. */
const SHORTEST_S = 600;

/** The lines of all groups in one scale, so that a minute is as long for all of them. */
export function linesOf(
  groups: readonly GroupReview[],
  timeOf: TimeOf,
  width: number,
): GroupLine[] {
  const spans = groups.map(({ marks }) => spansOf(marks));
  const common = new Axis(spans.flat());
  const axes = spans.map((own) => (timeOf === "clock" ? common : new Axis(own)));
  const longest = Math.max(SHORTEST_S, ...axes.map((axis) => axis.length));
  // room for the last mark, which begins at the end of the line
  const scale = Math.max(1, width - 40) / longest;
  const stretched = timeOf === "clock" ? stretchAll(groups, spans, common, width) : null;
  return groups.map(({ marks }, index) => {
    const axis = axes[index] ?? common;
    const zero = timeOf === "clock" ? midnight(axis.from) : axis.from;
    return {
      zero: timeOf === "clock" ? null : zero,
      layout: layOut({
        marks,
        spans: spans[index] ?? [],
        axis,
        width,
        scale,
        zero,
        ...(stretched && {
          common: { ...stretched, places: stretched.places[index] ?? [] },
        }),
      }),
    };
  });
}

function stretchAll(
  groups: readonly GroupReview[],
  spans: readonly (readonly Span[])[],
  common: Axis,
  width: number,
): Stretched {
  const moments = groups.map(({ marks }, index) => momentsOf(marks, spans[index] ?? [], common));
  return stretch(moments, width - 40);
}

/** The ruler of the clock has whole hours, also where time zones are half an hour apart. */
function midnight(seconds: number): number {
  return new Date(seconds * 1000).setHours(0, 0, 0, 0) / 1000;
}
