import { useSignal } from "@preact/signals";
import { useLayoutEffect, useMemo, useRef } from "preact/hooks";
import type { LessonReview } from "../../../api/model";
import { texts } from "../../../i18n";
import { daysOf } from "../days";
import { timelinesOf } from "../timeline/timelines";
import { GroupRow } from "./GroupRow";
import type { LessonViewState } from "./lesson_view_state";
import { computersOfLookalike } from "./lookalikes";
import { forPrint, PRINT_TIMELINE_PX } from "./printing";

/** Minimum width for which a timeline is laid out. */
const MIN_WIDTH_PX = 200;

interface GroupListProps {
  review: LessonReview;
  viewState: LessonViewState;
  onAccepted(): unknown;
}

/** Sections of the list, by the needs of groups. Within a section, groups are in the order of their names. */
const NEEDS = ["help", "working", "passed"] as const;

/** The groups of a lesson, with timelines of the width of the screen or the printed page. */
export function GroupList({ review: { groups }, viewState, onAccepted }: GroupListProps) {
  const { timeOf, open } = viewState;
  const { list, width } = useTimelineWidth();
  const lines = useMemo(
    () => timelinesOf(groups, timeOf.value, Math.max(MIN_WIDTH_PX, width)),
    [groups, timeOf.value, width],
  );
  const withDays = useMemo(() => daysOf(groups).length > 1, [groups]);
  const toggle = (id: string) => {
    const next = new Set(open.value);
    if (!next.delete(id)) next.add(id);
    open.value = next;
  };
  const rows = groups.map((review, index) => {
    const layout = lines[index];
    return (
      layout && (
        <GroupRow
          key={review.group.id}
          review={review}
          layout={layout}
          withDays={withDays}
          lookalikeOn={computersOfLookalike(review, groups)}
          open={open.value.has(review.group.id)}
          onToggle={() => toggle(review.group.id)}
          onAccepted={onAccepted}
        />
      )
    );
  });
  const parts = NEEDS.filter((need) => groups.some((one) => one.need === need));
  return (
    <div ref={list} data-time={timeOf.value}>
      {parts.map((need) => (
        <section key={need} data-need={need}>
          {parts.length > 1 && (
            <h2 class="lesson__need">{texts.value.review.lesson.needs[need]}</h2>
          )}
          <ol class="lesson__groups">{rows.filter((_, index) => groups[index]?.need === need)}</ol>
        </section>
      ))}
    </div>
  );
}

/** Width of a timeline in pixels; measured again on resize and for printing. */
function useTimelineWidth() {
  const list = useRef<HTMLDivElement>(null);
  const width = useSignal(0);
  useLayoutEffect(() => {
    const element = list.current;
    if (!element) return;
    const measure = () => {
      const line = element.querySelector(".group-row__work");
      if (line && !matchMedia("print").matches) width.value = line.clientWidth;
    };
    measure();
    const sizes = new ResizeObserver(measure);
    sizes.observe(element);
    const stop = forPrint(() => {
      width.value = PRINT_TIMELINE_PX;
    }, measure);
    return () => {
      sizes.disconnect();
      stop();
    };
  }, []);
  return { list, width: width.value };
}
