import { ArrowRight, BookOpen, Square } from "lucide-preact";
import { useEffect, useRef } from "preact/hooks";
import { classesApi } from "../../api/classes";
import type { ActivityChoice, Lesson } from "../../api/model";
import { language, texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { LinkButton } from "../../kit/LinkButton";
import { useAction } from "../../kit/requests/action";
import { FaultLine } from "../../kit/requests/FaultLine";
import { GoalPicture } from "../../scene/small/GoalPicture";
import { hashOf } from "../../shell/route";
import { asTeacher } from "../../shell/teacher/teacher_session";
import { dateAndTime } from "../time_format";

interface LessonNowProps {
  lesson: Lesson;
  activities: readonly ActivityChoice[];
  /** Whether it was opened on this page: its button has gone, so the link to the review takes the focus. */
  isNew: boolean;
  onClosed(): Promise<void>;
}

/** The open lesson of a class, with the link to its review and a button to close it. */
export function LessonNow({ lesson, activities, isNew, onClosed }: LessonNowProps) {
  const { lessons: labels } = texts.value.teacher;
  const { fault, act } = useAction(asTeacher);
  const review = useRef<HTMLAnchorElement>(null);
  useEffect(() => {
    if (isNew) review.current?.focus();
  }, [isNew, lesson.id]);
  const activity = activities.find((one) => one.name === lesson.activity);
  const since = labels.since({ when: dateAndTime(lesson.opened_at, language.value) });
  const close = async () => {
    await classesApi.changeLesson(lesson.id, { closed: true });
    await onClosed();
  };
  return (
    <div class="lesson-now row wrap middle gap-4" data-testid="lesson-now">
      {activity ? (
        <div class="lesson-goal">
          <GoalPicture goal={activity.goal_picture} />
        </div>
      ) : (
        <BookOpen class="icon lesson-now__icon" aria-hidden="true" />
      )}
      <p class="lesson-now__words column shrinks">
        <span>
          {labels.now} · {since}
        </span>
        <strong class="lesson-now__title">{lesson.title}</strong>
        {activity && activity.title !== lesson.title && <span>{activity.title}</span>}
      </p>
      <div class="row wrap gap-4">
        <LinkButton
          kind="main"
          elementRef={review}
          iconEnd={ArrowRight}
          href={hashOf({ screen: "lesson", lesson: lesson.id })}
          label={labels.reviewOf({ title: lesson.title })}
          testId="lesson-now-review"
        >
          {labels.review}
        </LinkButton>
        <Button filled icon={Square} testId="close-lesson" onPress={() => act(close)}>
          {labels.close}
        </Button>
      </div>
      <FaultLine fault={fault} />
    </div>
  );
}
