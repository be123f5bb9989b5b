import { useSignal } from "@preact/signals";
import { useLayoutEffect, useMemo, useRef } from "preact/hooks";
import type { LessonReview } from "../../../api/model";
import { daysOf } from "../days";
import { linesOf } from "../timeline/lines";
import { GroupRow } from "./GroupRow";
import type { LessonPlace } from "./lesson_place";
import { forPrint, PRINT_LINE_PX } from "./printing";

/** Minimum layout width of a timeline. */
const NARROWEST_PX = 200;

interface GroupListProps {
  review: LessonReview;
  place: LessonPlace;
}

/** The groups of a lesson, with timelines of the width of the screen or the printed page. */
export function GroupList({ review: { groups }, place: { timeOf, open } }: GroupListProps) {
  const { list, width } = useLineWidth();
  const lines = useMemo(
    () => linesOf(groups, timeOf.value, Math.max(NARROWEST_PX, width)),
    [groups, timeOf.value, width],
  );
  const withDays = useMemo(() => daysOf(groups).length > 1, [groups]);
  const toggle = (id: string) => {
    const next = new Set(open.value);
    if (!next.delete(id)) next.add(id);
    open.value = next;
  };
  return (
    <ol class="lesson__groups" ref={list} data-time={timeOf.value}>
      {groups.map((review, index) => {
        const line = lines[index];
        return (
          line && (
            <GroupRow
              key={review.group.id}
              review={review}
              layout={line}
              withDays={withDays}
              open={open.value.has(review.group.id)}
              onToggle={() => toggle(review.group.id)}
            />
          )
        );
      })}
    </ol>
  );
}

/** Width of a timeline in pixels; measured again on resize and for printing. */
function useLineWidth() {
  const list = useRef<HTMLOListElement>(null);
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
      width.value = PRINT_LINE_PX;
    }, measure);
    return () => {
      sizes.disconnect();
      stop();
    };
  }, []);
  return { list, width: width.value };
}
