import type { Signal } from "@preact/signals";
import { ArrowLeft, ListVideo, Printer, Sheet } from "lucide-preact";
import type { ComponentChildren } from "preact";
import { reviewApi } from "../api/review";
import { hashOf } from "../app/route";
import { fileName, saveFile } from "../app/save_file";
import { report } from "../app/session";
import { asTeacher } from "../app/teacher";
import { TEST } from "../app/testids";
import { language } from "../i18n";
import { words } from "../i18n/review";
import { daysInWords, daysOf } from "./days";
import type { TimeOf } from "./lines";
import type { LessonReview } from "./model";
import { canPrint, printPage } from "./printing";

/** A lesson with those that were joined to it. */
export interface Loaded {
  review: LessonReview;
  classroom: string | null;
  activities: readonly string[];
}

interface LessonHeadProps extends Loaded {
  timeOf: Signal<TimeOf>;
  refresh: ComponentChildren;
}

/** Which lesson it is, when it was and what it was about, and what can be done with it. */
export function LessonHead({ timeOf, refresh, ...loaded }: LessonHeadProps) {
  const { review } = loaded;
  return (
    <>
      <div class="lesson__head">
        <Back />
        <Title {...loaded} />
        {review.groups.length > 0 && <Tools review={review} timeOf={timeOf} />}
      </div>
      <div class="lesson__about">
        <p class="lesson__facts">{factsOf(loaded).join(" · ")}</p>
        {refresh}
      </div>
    </>
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

function Title({ review: { lesson }, classroom }: Pick<Loaded, "review" | "classroom">) {
  const texts = words.value.lesson;
  return (
    <h1 title={lesson.title}>
      <span class="lesson__class">{classroom ?? texts.noClass}</span> · {texts.title(lesson.title)}
    </h1>
  );
}

function factsOf({ review, activities }: Loaded): string[] {
  const texts = words.value.lesson;
  const { lesson, groups } = review;
  const days = daysOf(groups);
  const computers = computersOf(review);
  return [
    daysInWords(days.length > 0 ? days : [new Date(lesson.opened_at)], language.value),
    activities.length > 0
      ? texts.activities(activities.length, inList(activities))
      : texts.freeWork,
    texts.groups(groups.length),
    ...(computers.length > 0 ? [texts.computers(computers.join(", "))] : []),
  ];
}

const inList = (names: readonly string[]) =>
  new Intl.ListFormat(language.value, { type: "conjunction" }).format(names);

function computersOf({ lesson, groups }: LessonReview): string[] {
  const names = groups.flatMap(({ marks }) => marks.map(({ computer }) => computer));
  const known = new Set([...names, lesson.computer].filter((one) => one !== null));
  return [...known].sort((a, b) => a.localeCompare(b, language.value, { numeric: true }));
}

interface ToolsProps {
  review: LessonReview;
  timeOf: Signal<TimeOf>;
}

function Tools({ review, timeOf }: ToolsProps) {
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
