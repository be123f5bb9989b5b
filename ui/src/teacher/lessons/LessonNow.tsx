import { BookOpen, Square } from "lucide-preact";
import { classesApi } from "../../api/classes";
import type { ActivityChoice, Lesson } from "../../api/model";
import { language, texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { useAction } from "../../kit/requests/action";
import { FaultLine } from "../../kit/requests/FaultLine";
import { GoalPicture } from "../../scene/small/GoalPicture";
import { asTeacher } from "../../shell/teacher/teacher_session";
import { dateAndTime } from "../time_format";

interface LessonNowProps {
  lesson: Lesson;
  activities: readonly ActivityChoice[];
  onClosed(): Promise<void>;
}

/** The open lesson of a class, with a button to close it. */
export function LessonNow({ lesson, activities, onClosed }: LessonNowProps) {
  const { lessons: labels } = texts.value.teacher;
  const { fault, act } = useAction(asTeacher);
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
      <Button filled icon={Square} testId="close-lesson" onPress={() => act(close)}>
        {labels.close}
      </Button>
      <FaultLine fault={fault} />
    </div>
  );
}
