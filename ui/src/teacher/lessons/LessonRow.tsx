import { ArrowRight, Unlink2 } from "lucide-preact";
import type { ComponentChildren } from "preact";
import { classesApi } from "../../api/classes";
import type { Lesson, LessonChanges } from "../../api/model";
import { language, texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { LinkButton } from "../../kit/LinkButton";
import { hashOf } from "../../shell/route";
import { asTeacher } from "../../shell/teacher/teacher_session";
import { NameField } from "../NameField";
import { dateAndTime } from "../time_format";
import { titleOf } from "./lessons";

interface LessonRowProps {
  lesson: Lesson;
  onChanged(): Promise<void>;
  /** Whether the lesson is joined to the lesson above. */
  isPart?: boolean;
  /** Whether its review has a button above: the link then has no words. */
  isOpen?: boolean;
  /** Content before the title. */
  children?: ComponentChildren;
}

/** A lesson: title, time, PC, and the link to its review. */
export function LessonRow(props: LessonRowProps) {
  const { lesson, onChanged, isPart = false, isOpen = false, children } = props;
  const { lessons: labels } = texts.value.teacher;
  const title = titleOf(lesson);
  const change = async (changes: LessonChanges) => {
    await classesApi.changeLesson(lesson.id, changes);
    await onChanged();
  };
  const facts = [
    dateAndTime(lesson.opened_at, language.value),
    lesson.computer,
    labels.versions({ count: lesson.n_versions }),
    labels.runs({ count: lesson.n_runs }),
  ];
  return (
    <div
      class={`lesson-row row middle gap-3 ${isPart ? "lesson-row--part" : ""}`}
      data-testid="lesson-row"
    >
      {children}
      <div class="grows shrinks">
        <NameField
          name={lesson.title}
          label={labels.rename}
          onRename={(newTitle) => change({ title: newTitle })}
        >
          <span class={lesson.title ? "lesson-row__title" : "lesson-row__untitled"} title={title}>
            {title}
          </span>
        </NameField>
        <p class="lesson-row__facts">{facts.filter(Boolean).join(" · ")}</p>
      </div>
      {isPart ? (
        <Button
          kind="plain"
          icon={Unlink2}
          label={labels.apartOf({ title })}
          testId="lesson-apart"
          onPress={() => asTeacher(() => change({ part_of: "" }))}
        >
          {labels.apart}
        </Button>
      ) : (
        <LinkButton
          iconEnd={ArrowRight}
          href={hashOf({ screen: "lesson", lesson: lesson.id })}
          label={labels.reviewOf({ title })}
          testId="lesson-link"
        >
          {isOpen ? undefined : labels.review}
        </LinkButton>
      )}
    </div>
  );
}
