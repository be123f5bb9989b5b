import { ArrowRight } from "lucide-preact";
import { useState } from "preact/hooks";
import type { ActivityChoice, CurrentLesson as Current, Lesson } from "../../api/model";
import { texts } from "../../i18n";
import { LinkButton } from "../../kit/LinkButton";
import { hashOf } from "../../shell/route";
import { LessonNow } from "./LessonNow";
import { OpenLesson } from "./OpenLesson";

interface CurrentLessonProps {
  classroom: string;
  now: Current | null;
  activities: readonly ActivityChoice[];
  onChanged(): Promise<void>;
}

/** The open lesson of a class, or that there is none, and the form that opens one. */
export function CurrentLesson({ classroom, now, activities, onChanged }: CurrentLessonProps) {
  const [isNew, setNew] = useState(false);
  const open = now?.lesson?.by_itself === false ? now.lesson : null;
  const form = (
    <OpenLesson
      classroom={classroom}
      activities={activities}
      proposed={now?.preset.activity ?? ""}
      another={open !== null}
      onOpened={async () => {
        await onChanged();
        setNew(true);
      }}
    />
  );
  if (!open) {
    return (
      <section class="panel card">
        <NoLesson current={now?.lesson ?? null} />
        {form}
      </section>
    );
  }
  const { openAnother } = texts.value.teacher.lessons;
  return (
    <section class="panel card">
      <LessonNow lesson={open} activities={activities} isNew={isNew} onClosed={onChanged} />
      <details key={open.id} class="folded">
        <summary data-testid="open-another">{openAnother}</summary>
        {form}
      </details>
    </section>
  );
}

/** Says that the teacher opened no lesson; leads to one that opened by itself. */
function NoLesson({ current }: { current: Lesson | null }) {
  const { lessons: labels } = texts.value.teacher;
  if (!current) return <p class="teacher__hint">{labels.none}</p>;
  return (
    <div class="row wrap middle gap-4">
      <p class="teacher__hint grows shrinks">{labels.byItself}</p>
      <LinkButton
        iconEnd={ArrowRight}
        href={hashOf({ screen: "lesson", lesson: current.id })}
        testId="lesson-now-review"
      >
        {labels.review}
      </LinkButton>
    </div>
  );
}
