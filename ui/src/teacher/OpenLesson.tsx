import { ChevronDown, Play } from "lucide-preact";
import { useState } from "preact/hooks";
import { classesApi } from "../api/classes";
import { TEST } from "../app/testids";
import { useAct } from "./act";
import { useActivities } from "./activities";
import { FaultLine } from "./FaultLine";
import { Field } from "./Field";
import { words } from "./words";

interface OpenLessonProps {
  classroom: string;
  /** There is one that is open; opening this one closes it. */
  another: boolean;
  onOpened(): Promise<void>;
}

/** A title, an activity if there is one, and the lesson is open. */
export function OpenLesson({ classroom, another, onOpened }: OpenLessonProps) {
  const { lessons: say } = words.value;
  const [title, setTitle] = useState("");
  const [activity, setActivity] = useState("");
  const activities = useActivities();
  const { busy, fault, act, refuse, clear } = useAct();

  const open = async () => {
    await classesApi.openLesson(classroom, { title, activity: activity || null });
    await onOpened();
  };
  const submit = async (event: Event) => {
    event.preventDefault();
    if (!title.trim()) refuse(say.nameMissing);
    else if (await act(open)) setTitle("");
  };

  return (
    <form class="open-lesson" onSubmit={(event) => void submit(event)} noValidate>
      <h2>{another ? say.openAnother : say.open}</h2>
      <div class="teacher__row">
        <Field
          label={say.name}
          placeholder={say.namePlaceholder}
          value={title}
          maxLength={60}
          data-testid={TEST.lessonTitle}
          onText={(text) => {
            clear();
            setTitle(text);
          }}
        />
        <label class="labelled">
          <span class="labelled__label">{say.activity}</span>
          <span class="select open-lesson__activity">
            <select
              value={activity}
              data-testid={TEST.lessonActivity}
              onChange={({ currentTarget }) => setActivity(currentTarget.value)}
            >
              <option value="">{say.noActivity}</option>
              {activities.map((one) => (
                <option key={one.name} value={one.name}>
                  {one.title}
                </option>
              ))}
            </select>
            <ChevronDown class="icon icon--end" aria-hidden="true" />
          </span>
        </label>
        <button
          type="submit"
          class="button button--run"
          disabled={busy}
          data-testid={TEST.openLesson}
        >
          <Play class="icon" aria-hidden="true" />
          {say.go}
        </button>
      </div>
      <FaultLine fault={fault} />
      <p class="labelled__hint">{say.same}</p>
    </form>
  );
}
