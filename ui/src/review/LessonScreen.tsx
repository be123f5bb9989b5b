import { type Signal, useSignal } from "@preact/signals";
import { ArrowLeft, ListVideo, Printer, Sheet } from "lucide-preact";
import { useEffect, useLayoutEffect, useMemo, useRef } from "preact/hooks";
import { classesApi } from "../api/classes";
import { reviewApi } from "../api/review";
import { hashOf } from "../app/route";
import { fileName, saveFile } from "../app/save_file";
import { report } from "../app/session";
import { asTeacher } from "../app/teacher";
import { TEST } from "../app/testids";
import { language } from "../i18n";
import { figureWords, words } from "../i18n/review";
import { NotOpened } from "../screens/NotOpened";
import { Behind } from "./Behind";
import { FIGURES } from "./FigureRow";
import { GroupRow } from "./GroupRow";
import { Legend } from "./Legend";
import { type LessonPlace, placeOf } from "./lesson_place";
import { linesOf, type TimeOf } from "./lines";
import type { LessonReview } from "./model";
import { canPrint, forPaper, PAPER_PX, printPage } from "./printing";
import { useScrollPlace } from "./scroll_place";
import { TipBubble } from "./TipBubble";

interface Loaded {
  review: LessonReview;
  classroom: string | null;
  activity: string | null;
}

/** A lesson as its groups went through it: one line for each. */
export function LessonScreen({ lessonId }: { lessonId: string }) {
  return (
    <Behind>
      <Opened lessonId={lessonId} />
    </Behind>
  );
}

function Opened({ lessonId }: { lessonId: string }) {
  const loaded = useSignal<Loaded | null>(null);
  const failed = useSignal(false);
  useEffect(() => {
    let left = false;
    load(lessonId).then(
      (found) => {
        if (!left) loaded.value = found;
      },
      (error) => {
        failed.value = true;
        report(error);
      },
    );
    document.documentElement.dataset.page = "lesson";
    return () => {
      left = true;
      delete document.documentElement.dataset.page;
    };
  }, [lessonId]);
  if (failed.value) return <NotOpened />;
  if (!loaded.value) {
    return (
      <main class="screen lesson lesson--opening" aria-busy="true">
        <p>{words.value.lesson.opening}</p>
      </main>
    );
  }
  return <Lesson {...loaded.value} />;
}

async function load(id: string): Promise<Loaded> {
  const review = await asTeacher(() => reviewApi.lesson(id));
  const [classrooms, activities] = await Promise.all([
    classesApi.classrooms(),
    classesApi.activities(),
  ]);
  const { classroom_id, activity } = review.lesson;
  return {
    review,
    classroom: classrooms.find((one) => one.id === classroom_id)?.name ?? null,
    activity: activities.find((one) => one.name === activity)?.title ?? activity,
  };
}

function Lesson(loaded: Loaded) {
  const { lesson } = words.value;
  const { groups } = loaded.review;
  const place = placeOf(loaded.review.lesson.id);
  const { timeOf } = place;
  const main = useScrollPlace(place, true);
  const hasRuns = groups.some(({ figures }) => figures.n_runs > 0);
  return (
    <main class="screen lesson" ref={main} data-testid={TEST.lessonPage}>
      <div class="lesson__head">
        <Back />
        <Title {...loaded} />
        {groups.length > 0 && <Tools {...loaded} timeOf={timeOf} />}
      </div>
      <p class="lesson__facts">{factsOf(loaded).join(" · ")}</p>
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

function Back() {
  const { back } = words.value.lesson;
  return (
    <a
      class="button button--icon lesson__back"
      href={hashOf({ screen: "teacher", part: "lessons" })}
      aria-label={back}
      title={back}
    >
      <ArrowLeft class="icon" aria-hidden="true" />
    </a>
  );
}

function Title({ review: { lesson }, classroom }: Loaded) {
  const texts = words.value.lesson;
  return (
    <h1 title={lesson.title}>
      <span class="lesson__class">{classroom ?? texts.noClass}</span> · {texts.title(lesson.title)}
    </h1>
  );
}

function factsOf({ review, activity }: Loaded): string[] {
  const texts = words.value.lesson;
  const { lesson, groups } = review;
  const day = new Date(lesson.opened_at).toLocaleDateString(language.value, {
    weekday: "long",
    day: "numeric",
    month: "long",
    year: "numeric",
  });
  const computers = computersOf(review);
  return [
    day.charAt(0).toUpperCase() + day.slice(1),
    activity ? texts.activity(activity) : texts.freeWork,
    texts.groups(groups.length),
    ...(computers.length > 0 ? [texts.computers(computers.join(", "))] : []),
  ];
}

function computersOf({ lesson, groups }: LessonReview): string[] {
  const names = groups.flatMap(({ marks }) => marks.map(({ computer }) => computer));
  const known = new Set([...names, lesson.computer].filter((one) => one !== null));
  return [...known].sort((a, b) => a.localeCompare(b, language.value, { numeric: true }));
}

function Tools({ review, timeOf }: Loaded & { timeOf: Signal<TimeOf> }) {
  const texts = words.value.lesson;
  return (
    <div class="lesson__tools">
      <TimeChoice timeOf={timeOf} />
      <a class="button" href={hashOf({ screen: "runs" })}>
        <ListVideo class="icon" aria-hidden="true" />
        {texts.runs}
      </a>
      <button
        type="button"
        class="button"
        title={texts.tableHelp}
        data-testid={TEST.lessonTable}
        onClick={() => void saveTable(review).catch(report)}
      >
        <Sheet class="icon" aria-hidden="true" />
        {texts.table}
      </button>
      {canPrint() && (
        <button
          type="button"
          class="button"
          data-testid={TEST.lessonPrint}
          onClick={() => printPage()}
        >
          <Printer class="icon" aria-hidden="true" />
          {texts.print}
        </button>
      )}
    </div>
  );
}

async function saveTable({ lesson }: LessonReview): Promise<void> {
  const table = await asTeacher(() => reviewApi.table(lesson.id));
  saveFile(`${fileName(lesson.title, words.value.lesson.fileName)}.csv`, table);
}

function TimeChoice({ timeOf }: { timeOf: Signal<TimeOf> }) {
  const { lesson } = words.value;
  const choices = [
    ["group", lesson.ownTime, lesson.ownTimeHelp],
    ["clock", lesson.sameTime, lesson.sameTimeHelp],
  ] as const;
  return (
    <fieldset class="switch">
      <legend class="switch__word">{lesson.clock}</legend>
      {choices.map(([name, word, help]) => (
        <button
          key={name}
          type="button"
          class="button"
          title={help}
          aria-pressed={timeOf.value === name}
          data-testid={TEST.lessonTime}
          data-value={name}
          onClick={() => {
            timeOf.value = name;
          }}
        >
          {word}
        </button>
      ))}
    </fieldset>
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
              layout={line.layout}
              zero={line.zero}
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
