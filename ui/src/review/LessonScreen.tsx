import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect, useLayoutEffect, useMemo, useRef } from "preact/hooks";
import { classesApi } from "../api/classes";
import { reviewApi } from "../api/review";
import { toldApart } from "../app/namesakes";
import { TEST } from "../app/testids";
import { language } from "../i18n";
import { figureWords, words } from "../i18n/review";
import { NotOpened } from "../screens/NotOpened";
import { Behind } from "./Behind";
import { daysOf } from "./days";
import { FIGURES } from "./FigureRow";
import { GroupRow } from "./GroupRow";
import { Legend } from "./Legend";
import { LessonHead, type Loaded } from "./LessonHead";
import { type LessonPlace, placeOf } from "./lesson_place";
import { linesOf } from "./lines";
import type { LessonReview } from "./model";
import { forPaper, PAPER_PX } from "./printing";
import { Refresh } from "./Refresh";
import { useScrollPlace } from "./scroll_place";
import { useSeen } from "./seen";
import { TipBubble } from "./TipBubble";

/** A lesson as its groups went through it: one line for each. */
export function LessonScreen({ lessonId }: { lessonId: string }) {
  return (
    <Behind>
      <Opened lessonId={lessonId} />
    </Behind>
  );
}

function Opened({ lessonId }: { lessonId: string }) {
  const { seen, busy, failed, again } = useSeen(lessonId, () => load(lessonId));
  useEffect(() => {
    document.documentElement.dataset.page = "lesson";
    return () => {
      delete document.documentElement.dataset.page;
    };
  }, []);
  if (failed.value) return <NotOpened />;
  if (!seen.value) {
    return (
      <main class="screen lesson lesson--opening" aria-busy="true">
        <p>{words.value.lesson.opening}</p>
      </main>
    );
  }
  const { what, at } = seen.value;
  return <Lesson {...what} refresh={<Refresh at={at} busy={busy.value} onRefresh={again} />} />;
}

async function load(id: string): Promise<Loaded> {
  const review = await reviewApi.lesson(id);
  const { id: whole, classroom_id } = review.lesson;
  const [classrooms, activities, lessons] = await Promise.all([
    classesApi.classrooms(),
    classesApi.activities(),
    classesApi.lessons(classroom_id ?? "none"),
  ]);
  const named = [review.lesson, ...lessons.filter((one) => one.part_of === whole)].flatMap(
    ({ activity }) => activity ?? [],
  );
  return {
    review,
    classroom:
      toldApart(classrooms, language.value).find((one) => one.id === classroom_id)?.name ?? null,
    activities: [...new Set(named)].map(
      (name) => activities.find((one) => one.name === name)?.title ?? name,
    ),
  };
}

function Lesson({ refresh, ...loaded }: Loaded & { refresh: ComponentChildren }) {
  const { lesson } = words.value;
  const { groups } = loaded.review;
  const place = placeOf(loaded.review.lesson.id);
  const main = useScrollPlace(place, true);
  const hasRuns = groups.some(({ figures }) => figures.n_runs > 0);
  return (
    <main class="screen lesson" ref={main} data-testid={TEST.lessonPage}>
      <LessonHead {...loaded} timeOf={place.timeOf} refresh={refresh} />
      {groups.length > 0 && <Legend />}
      {groups.length === 0 && (
        <div class="lesson__empty" data-testid={TEST.lessonEmpty}>
          <strong>{lesson.emptyTitle}</strong>
          <p>{lesson.empty}</p>
        </div>
      )}
      {groups.length > 0 && !hasRuns && (
        <p class="lesson__no-runs">
          <strong>{lesson.noRunsTitle}.</strong> {lesson.noRuns}
        </p>
      )}
      {groups.length > 0 && <Groups review={loaded.review} place={place} />}
      {groups.length > 0 && <Explained />}
      <TipBubble />
    </main>
  );
}

interface GroupsProps {
  review: LessonReview;
  place: LessonPlace;
}

function Groups({ review: { groups }, place: { timeOf, open } }: GroupsProps) {
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
    const stop = forPaper(() => {
      width.value = PAPER_PX;
    }, measure);
    return () => {
      sizes.disconnect();
      stop();
    };
  }, []);
  const lines = useMemo(
    () => linesOf(groups, timeOf.value, Math.max(200, width.value)),
    [groups, timeOf.value, width.value],
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

/** On paper nobody can ask what a number counts. */
function Explained() {
  const { lesson } = words.value;
  const today = new Date().toLocaleString(language.value, {
    dateStyle: "long",
    timeStyle: "short",
  });
  return (
    <section class="lesson__explained" data-testid={TEST.lessonExplained}>
      <h2>{lesson.counts}</h2>
      <p>{lesson.noRanking}</p>
      <dl>
        {[...FIGURES, "blocks", "repairs"].map((name) => {
          const { message, remedy } = figureWords(name);
          return (
            <div key={name}>
              <dt>{message}</dt>
              <dd>{remedy}</dd>
            </div>
          );
        })}
      </dl>
      <p>{lesson.printed(today)}</p>
    </section>
  );
}
