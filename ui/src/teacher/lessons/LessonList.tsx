import { ChevronDown, Link2 } from "lucide-preact";
import { useState } from "preact/hooks";
import { classesApi } from "../../api/classes";
import type { Lesson } from "../../api/model";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { useAction } from "../../kit/requests/action";
import { FaultLine } from "../../kit/requests/FaultLine";
import { asTeacher } from "../../shell/teacher/teacher_session";
import { LessonRow } from "./LessonRow";
import { titleOf, whole, withParts } from "./lessons";

/** Older lessons are shown on request: what is below the list stays near. */
const SHOWN_AT_FIRST = 4;

interface LessonListProps {
  lessons: readonly Lesson[];
  /** Id of the lesson that is open. */
  open: string | null;
  onChanged(): Promise<void>;
}

/** The lessons of a class, newest first, with selection to join several. */
export function LessonList({ lessons, open, onChanged }: LessonListProps) {
  const { lessons: labels } = texts.value.teacher;
  const [isWhole, setWhole] = useState(false);
  const [picked, setPicked] = useState<readonly string[]>([]);
  const { fault, act } = useAction(asTeacher);
  const groups = withParts(lessons);
  const marked = groups.map((one) => one.lesson).filter((one) => picked.includes(one.id));
  const join = async () => {
    const target = whole(marked);
    for (const one of marked.filter((other) => other !== target)) {
      await classesApi.changeLesson(one.id, { part_of: target?.id ?? "" });
    }
    setPicked([]);
    await onChanged();
  };
  const mark = (id: string, on: boolean) =>
    setPicked(on ? [...picked, id] : picked.filter((one) => one !== id));
  return (
    <section>
      <h2 class="lessons__title">{labels.list}</h2>
      {lessons.length === 0 && <p class="teacher__hint">{labels.empty}</p>}
      <ul class="column gap-2">
        {(isWhole ? groups : groups.slice(0, SHOWN_AT_FIRST)).map(({ lesson, parts }) => (
          <li key={lesson.id} class="card">
            <LessonRow lesson={lesson} onChanged={onChanged} isOpen={lesson.id === open}>
              {groups.length > 1 && (
                <input
                  type="checkbox"
                  class="lessons__pick"
                  aria-label={labels.pick({ title: titleOf(lesson) })}
                  checked={picked.includes(lesson.id)}
                  data-testid="lesson-pick"
                  onChange={({ currentTarget }) => mark(lesson.id, currentTarget.checked)}
                />
              )}
            </LessonRow>
            {parts.map((part) => (
              <LessonRow key={part.id} lesson={part} onChanged={onChanged} isPart />
            ))}
          </li>
        ))}
      </ul>
      {!isWhole && groups.length > SHOWN_AT_FIRST && (
        <Button
          kind="plain"
          icon={ChevronDown}
          testId="lessons-earlier"
          onPress={() => setWhole(true)}
        >
          {labels.earlier({ count: groups.length - SHOWN_AT_FIRST })}
        </Button>
      )}
      {groups.length > 1 && <Join n={marked.length} onJoin={() => act(join)} />}
      <FaultLine fault={fault} />
    </section>
  );
}

interface JoinProps {
  /** Number of selected lessons. */
  n: number;
  onJoin(): unknown;
}

function Join({ n, onJoin }: JoinProps) {
  const { lessons: labels } = texts.value.teacher;
  return (
    <div class="button-row lessons__join">
      <Button icon={Link2} disabled={n < 2} testId="lesson-join" onPress={onJoin}>
        {labels.join}
      </Button>
      <p class="labelled__hint">{n > 1 ? labels.picked({ n }) : labels.joinHint}</p>
    </div>
  );
}
