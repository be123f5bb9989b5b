import { Axis, type Span, spansOf } from "./axis";
import { daysOf } from "./days";
import { type LineLayout, layOut, momentsOf } from "./line_layout";
import type { GroupReview } from "./model";
import { type Stretched, stretch } from "./stretch";

/** Whose time the lines show: each group's own, or the clock on the wall. */
export type TimeOf = "group" | "clock";

/** A line is at least so long, for the marks of two minutes not to be strewn over a metre. Seconds. */
const SHORTEST_S = 600;

/** The lines of all groups in one scale, so that a minute is as long for all of them. */
export function linesOf(
  groups: readonly GroupReview[],
  timeOf: TimeOf,
  width: number,
): LineLayout[] {
  const spans = groups.map(({ marks }) => spansOf(marks));
  const common = new Axis(spans.flat());
  const axes = spans.map((own) => (timeOf === "clock" ? common : new Axis(own)));
  const longest = Math.max(SHORTEST_S, ...axes.map((axis) => axis.length));
  // room for the last mark, which begins at the end of the line
  const scale = Math.max(1, width - 40) / longest;
  const withDays = daysOf(groups).length > 1;
  const stretched = timeOf === "clock" ? stretchAll(groups, spans, common, width) : null;
  return groups.map(({ marks }, index) => {
    return layOut({
      marks,
      spans: spans[index] ?? [],
      axis: axes[index] ?? common,
      width,
      scale,
      byClock: timeOf === "clock",
      withDays,
      ...(stretched && {
        common: { ...stretched, places: stretched.places[index] ?? [] },
      }),
    });
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
