import { Play } from "lucide-preact";
import { useState } from "preact/hooks";
import { classesApi } from "../../api/classes";
import { STORE_LIMITS } from "../../api/declared";
import type { ActivityChoice } from "../../api/model";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { Field } from "../../kit/Field";
import { Form } from "../../kit/Form";
import { useAction } from "../../kit/requests/action";
import { FaultLine } from "../../kit/requests/FaultLine";
import { LabelledSelect, type SelectOption } from "../../kit/Select";
import { GoalPicture } from "../../scene/small/GoalPicture";
import { asTeacher } from "../../shell/teacher/teacher_session";
import { useDraft } from "../useDraft";

interface OpenLessonProps {
  classroom: string;
  activities: readonly ActivityChoice[];
  /** Name of the activity in the preset of the class, or "". */
  proposed: string;
  /** Whether another lesson is open: a button with the form's title folds it, and opening a lesson closes the other. */
  another: boolean;
  onOpened(): Promise<void>;
}

/** Opens a lesson with a title, an activity, or both. */
export function OpenLesson(props: OpenLessonProps) {
  const { classroom, activities, proposed, another, onOpened } = props;
  const { lessons: labels } = texts.value.teacher;
  const [activity, setActivity] = useState(proposed);
  const { busy, fault, act, refuse, clear } = useAction(asTeacher);
  const { draft, field, reset } = useDraft({ title: "" }, clear);
  const goal = activities.find(({ name }) => name === activity)?.goal_picture;
  const open = async () => {
    await classesApi.openLesson(classroom, { title: draft.title, activity: activity || null });
    await onOpened();
  };
  const submit = async () => {
    if (!draft.title.trim() && !activity) refuse(labels.nameMissing);
    else if (await act(open)) reset();
  };
  return (
    <Form class="open-lesson column gap-3" onSubmit={submit}>
      {!another && <h2>{labels.open}</h2>}
      <div class="teacher__row">
        <Field
          label={labels.name}
          placeholder={labels.namePlaceholder}
          maxLength={STORE_LIMITS.MAX_NAME}
          data-testid="lesson-title"
          {...field("title")}
        />
        <LabelledSelect
          label={labels.activity}
          value={activity}
          testId="lesson-activity"
          options={[["", labels.noActivity]]}
          groups={groupsOf(activities)}
          onChange={(name) => setActivity(name)}
        />
        <Button submit kind="main" icon={Play} busy={busy} testId="open-lesson">
          {labels.go}
        </Button>
      </div>
      {goal && (
        <div class="lesson-goal" data-testid="lesson-goal">
          <GoalPicture goal={goal} label={texts.value.activity.goal} />
        </div>
      )}
      <FaultLine fault={fault} />
      <p class="labelled__hint">{labels.same}</p>
    </Form>
  );
}

/** Activities as option groups, own activities first. */
function groupsOf(activities: readonly ActivityChoice[]) {
  const { activity, teacher } = texts.value;
  const options = (own: boolean) =>
    activities
      .filter((one) => one.own === own)
      .map(({ name, title }): SelectOption<string> => [name, title]);
  const groups = [
    [activity.paths.own, options(true)],
    [teacher.lessons.shipped, options(false)],
  ] as const;
  return groups.filter(([, inside]) => inside.length > 0);
}
