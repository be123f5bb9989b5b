import type { GroupReview } from "../../../api/model";
import { daysOf } from "../days";
import { Axis, type Span, spansOf } from "./axis";
import { type Stretched, stretch } from "./stretch";
import { layOut, pointsOf, type TimelineLayout } from "./timeline_layout";

/** Meaning of positions: time since the group's first event, or time of day. */
export type TimeOf = "group" | "clock";

/** Minimum length of a timeline in seconds, so that two minutes do not fill the whole screen. */
const MIN_LENGTH_S = 600;

/** Layouts of all groups in one scale: a minute has the same length on all timelines. */
export function timelinesOf(
  groups: readonly GroupReview[],
  timeOf: TimeOf,
  width: number,
): TimelineLayout[] {
  const spans = groups.map(({ entries }) => spansOf(entries));
  const common = new Axis(spans.flat());
  const axes = spans.map((own) => (timeOf === "clock" ? common : new Axis(own)));
  const maxLength = Math.max(MIN_LENGTH_S, ...axes.map((axis) => axis.length));
  // leaves space for the last event, which starts at the end of the timeline
  const scale = Math.max(1, width - 40) / maxLength;
  const withDays = daysOf(groups).length > 1;
  const stretched = timeOf === "clock" ? stretchAll(groups, spans, common, width) : null;
  return groups.map(({ entries }, index) => {
    return layOut({
      entries,
      spans: spans[index] ?? [],
      axis: axes[index] ?? common,
      width,
      scale,
      byClock: timeOf === "clock",
      withDays,
      ...(stretched && {
        common: { ...stretched, positions: stretched.positions[index] ?? [] },
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
  const points = groups.map(({ entries }, index) => pointsOf(entries, spans[index] ?? [], common));
  return stretch(points, width - 40);
}
