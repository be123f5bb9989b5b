import type { Signal } from "@preact/signals";
import { ListVideo, Printer, Sheet } from "lucide-preact";
import type { ComponentChildren } from "preact";
import type { LessonReview } from "../../../api/model";
import { reviewApi } from "../../../api/review";
import { language, texts } from "../../../i18n";
import { Button } from "../../../kit/Button";
import { Choice } from "../../../kit/Choice";
import { LinkButton } from "../../../kit/LinkButton";
import { hashOf } from "../../../shell/route";
import { fileName, saveFile } from "../../../shell/save_file";
import { asTeacher } from "../../../shell/teacher/teacher_session";
import { BackToLessons } from "../BackToLessons";
import { daysInWords, daysOf } from "../days";
import type { TimeOf } from "../timeline/lines";
import { LessonSummary } from "./LessonSummary";
import type { LessonPlace } from "./lesson_place";
import type { LessonPage } from "./load_lesson";
import { canPrint, printPage } from "./printing";

interface LessonHeadProps {
  page: LessonPage;
  place: LessonPlace;
  refresh: ComponentChildren;
}

/** Title, time and activities of a lesson, with its actions. */
export function LessonHead({ page, place, refresh }: LessonHeadProps) {
  const { review } = page;
  return (
    <>
      <div class="review-head lesson__head row middle gap-4">
        <BackToLessons />
        <Title page={page} />
        {review.groups.length > 0 && <Tools review={review} timeOf={place.timeOf} />}
      </div>
      <div class="lesson__about row middle apart gap-4">
        <p class="lesson__facts">{factsOf(page).join(" · ")}</p>
        {refresh}
      </div>
      <LessonSummary review={review} place={place} />
    </>
  );
}

function Title({ page: { review, classroom } }: Pick<LessonHeadProps, "page">) {
  const { lesson } = review;
  const say = texts.value.review.lesson;
  return (
    <h1 title={lesson.title}>
      <span class="lesson__class">{classroom ?? say.noClass}</span> · {say.title(lesson.title)}
    </h1>
  );
}

function factsOf({ review, activities }: LessonPage): string[] {
  const say = texts.value.review.lesson;
  const { lesson, groups } = review;
  const days = daysOf(groups);
  const computers = computersOf(review);
  return [
    daysInWords(days.length > 0 ? days : [new Date(lesson.opened_at)], language.value),
    activities.length > 0 ? say.activities(activities.length, inList(activities)) : say.freeWork,
    say.groups(groups.length),
    ...(computers.length > 0 ? [say.computers(computers.join(", "))] : []),
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
  const say = texts.value.review.lesson;
  return (
    <div class="lesson__tools row rigid gap-2">
      <TimeChoice timeOf={timeOf} />
      <LinkButton icon={ListVideo} href={hashOf({ screen: "runs" })}>
        {say.runs}
      </LinkButton>
      <Button
        icon={Sheet}
        tip={say.tableHelp}
        testId="lesson-table"
        onPress={() => saveTable(review)}
      >
        {say.table}
      </Button>
      {canPrint() && (
        <Button icon={Printer} testId="lesson-print" onPress={printPage}>
          {say.print}
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
  const { lesson: say } = texts.value.review;
  return (
    <Choice<TimeOf>
      class="switch row middle shrinks"
      label={say.clock}
      legendClass="switch__word"
      optionClass=""
      testId="lesson-time"
      value={timeOf.value}
      options={[
        ["group", say.ownTime, { tip: say.ownTimeHelp }],
        ["clock", say.sameTime, { tip: say.sameTimeHelp }],
      ]}
      onChange={(chosen) => {
        timeOf.value = chosen;
      }}
    />
  );
}
