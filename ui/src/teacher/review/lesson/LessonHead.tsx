import type { Signal } from "@preact/signals";
import { ListVideo, Printer, Sheet } from "lucide-preact";
import type { ComponentChildren } from "preact";
import type { LessonReview } from "../../../api/model";
import { reviewApi } from "../../../api/review";
import { language, texts } from "../../../i18n";
import { Button } from "../../../kit/Button";
import { LinkButton } from "../../../kit/LinkButton";
import { RadioGroup } from "../../../kit/RadioGroup";
import { canPrint } from "../../../shell/files/printing";
import { fileName, saveFile } from "../../../shell/files/save_file";
import { hashOf } from "../../../shell/route";
import { asTeacher } from "../../../shell/teacher/teacher_session";
import { BackToLessons } from "../BackToLessons";
import { daysOf, daysText } from "../days";
import type { TimeOf } from "../timeline/timelines";
import { LessonSummary } from "./LessonSummary";
import type { LessonViewState } from "./lesson_view_state";
import type { LessonPage } from "./load_lesson";
import { printReview } from "./printing";

interface LessonHeadProps {
  page: LessonPage;
  viewState: LessonViewState;
  refresh: ComponentChildren;
}

/** Title, time and activities of a lesson, with its actions. */
export function LessonHead({ page, viewState, refresh }: LessonHeadProps) {
  const { review } = page;
  return (
    <>
      <div class="review-head lesson__head row middle gap-4">
        <BackToLessons />
        <Title page={page} />
        {review.groups.length > 0 && <Tools review={review} timeOf={viewState.timeOf} />}
      </div>
      <div class="lesson__about row middle apart gap-4">
        <p class="lesson__facts">{factsOf(page).join(" · ")}</p>
        {refresh}
      </div>
      <LessonSummary review={review} viewState={viewState} />
    </>
  );
}

function Title({ page: { review, classroom } }: Pick<LessonHeadProps, "page">) {
  const { lesson } = review;
  const labels = texts.value.review.lesson;
  return (
    <h1 title={lesson.title}>
      <span class="lesson__class">{classroom ?? labels.noClass}</span> ·{" "}
      {lesson.title || labels.untitled}
    </h1>
  );
}

function factsOf({ review, activities }: LessonPage): string[] {
  const labels = texts.value.review.lesson;
  const { lesson, groups } = review;
  const days = daysOf(groups);
  const computers = computersOf(review);
  return [
    daysText(days.length > 0 ? days : [new Date(lesson.opened_at)], language.value),
    activities.length > 0
      ? labels.activities({ count: activities.length, names: inList(activities) })
      : labels.freeWork,
    labels.groups({ count: groups.length }),
    ...(computers.length > 0 ? [labels.computers({ names: computers.join(", ") })] : []),
  ];
}

const inList = (names: readonly string[]) =>
  new Intl.ListFormat(language.value, { type: "conjunction" }).format(names);

function computersOf({ lesson, groups }: LessonReview): string[] {
  const names = groups.flatMap(({ entries }) => entries.map(({ computer }) => computer));
  const known = new Set([...names, lesson.computer].filter((one) => one !== null));
  return [...known].sort((a, b) => a.localeCompare(b, language.value, { numeric: true }));
}

interface ToolsProps {
  review: LessonReview;
  timeOf: Signal<TimeOf>;
}

function Tools({ review, timeOf }: ToolsProps) {
  const labels = texts.value.review.lesson;
  return (
    <div class="lesson__tools row rigid gap-2">
      <TimeChoice timeOf={timeOf} />
      <LinkButton icon={ListVideo} href={hashOf({ screen: "runs" })}>
        {labels.runs}
      </LinkButton>
      <Button
        icon={Sheet}
        tip={labels.tableHelp}
        testId="lesson-table"
        onPress={() => saveTable(review)}
      >
        {labels.table}
      </Button>
      {canPrint() && (
        <Button icon={Printer} testId="lesson-print" onPress={printReview}>
          {labels.print}
        </Button>
      )}
    </div>
  );
}

async function saveTable({ lesson }: LessonReview): Promise<void> {
  const table = await asTeacher(() => reviewApi.table(lesson.id));
  saveFile(`${fileName(lesson.title, texts.value.review.lesson.fileName)}.csv`, table);
}

function TimeChoice({ timeOf }: Pick<ToolsProps, "timeOf">) {
  const { lesson: labels } = texts.value.review;
  return (
    <RadioGroup<TimeOf>
      class="switch row middle shrinks"
      label={labels.clock}
      legendClass="switch__word"
      optionClass=""
      testId="lesson-time"
      value={timeOf.value}
      options={[
        ["group", labels.ownTime, { tip: labels.ownTimeHelp }],
        ["clock", labels.sameTime, { tip: labels.sameTimeHelp }],
      ]}
      onChange={(chosen) => {
        timeOf.value = chosen;
      }}
    />
  );
}
