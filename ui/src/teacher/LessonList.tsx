import { ArrowRight, Link2, Unlink2 } from "lucide-preact";
import type { ComponentChildren } from "preact";
import { useState } from "preact/hooks";
import { classesApi } from "../api/classes";
import type { Lesson } from "../api/model";
import { hashOf } from "../app/route";
import { TEST } from "../app/testids";
import { useAct } from "./act";
import { FaultLine } from "./FaultLine";
import { whole, withParts } from "./lessons";
import { momentOf } from "./moments";
import { NameField } from "./NameField";
import { words } from "./words";

interface LessonListProps {
  lessons: readonly Lesson[];
  onChanged(): Promise<void>;
}

/** The lessons of a class, newest first; some can be marked and joined. */
export function LessonList({ lessons, onChanged }: LessonListProps) {
  const { lessons: say } = words.value;
  const [picked, setPicked] = useState<string[]>([]);
  const { busy, fault, act } = useAct();
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
      <h2 class="lessons__title">{say.list}</h2>
      {lessons.length === 0 && <p class="teacher__hint">{say.empty}</p>}
      <ul class="lessons">
        {groups.map(({ lesson, parts }) => (
          <li key={lesson.id} class="lessons__group card">
            <Row lesson={lesson} onChanged={onChanged}>
              {groups.length > 1 && (
                <input
                  type="checkbox"
                  class="lessons__pick"
                  aria-label={say.pick(titleOf(lesson))}
                  checked={picked.includes(lesson.id)}
                  data-testid={TEST.lessonPick}
                  onChange={({ currentTarget }) => mark(lesson.id, currentTarget.checked)}
                />
              )}
            </Row>
            {parts.map((part) => (
              <Row key={part.id} lesson={part} onChanged={onChanged} isPart />
            ))}
          </li>
        ))}
      </ul>
      {groups.length > 1 && (
        <div class="lessons__join">
          <button
            type="button"
            class="button"
            disabled={busy || marked.length < 2}
            data-testid={TEST.lessonJoin}
            onClick={() => void act(join)}
          >
            <Link2 class="icon" aria-hidden="true" />
            {say.join}
          </button>
          <p class="labelled__hint">
            {marked.length > 1 ? say.picked(marked.length) : say.joinHint}
          </p>
        </div>
      )}
      <FaultLine fault={fault} />
    </section>
  );
}

interface RowProps {
  lesson: Lesson;
  onChanged(): Promise<void>;
  isPart?: boolean;
  children?: ComponentChildren;
}

function Row({ lesson, onChanged, isPart = false, children }: RowProps) {
  const { lessons: say } = words.value;
  const { busy, act } = useAct();
  const change = async (changes: { title?: string; part_of?: string }) => {
    await classesApi.changeLesson(lesson.id, changes);
    await onChanged();
  };
  const title = titleOf(lesson);
  return (
    <div class={`lesson-row ${isPart ? "lesson-row--part" : ""}`} data-testid={TEST.lessonRow}>
      {children}
      <div class="lesson-row__words">
        <NameField
          name={lesson.title}
          label={say.rename}
          onRename={(wanted) => change({ title: wanted })}
        >
          <span class={lesson.title ? "lesson-row__title" : "lesson-row__untitled"} title={title}>
            {title}
          </span>
        </NameField>
        <p class="lesson-row__line">
          {[
            momentOf(lesson.opened_at),
            lesson.computer,
            say.edits(lesson.n_versions),
            say.runs(lesson.n_runs),
          ]
            .filter(Boolean)
            .join(" · ")}
        </p>
      </div>
      {isPart ? (
        <button
          type="button"
          class="button button--plain"
          disabled={busy}
          aria-label={say.apartOf(title)}
          data-testid={TEST.lessonApart}
          onClick={() => void act(() => change({ part_of: "" }))}
        >
          <Unlink2 class="icon" aria-hidden="true" />
          {say.apart}
        </button>
      ) : (
        <a
          class="button"
          href={hashOf({ screen: "lesson", lesson: lesson.id })}
          aria-label={say.reviewOf(title)}
          data-testid={TEST.lessonLink}
        >
          {say.review}
          <ArrowRight class="icon" aria-hidden="true" />
        </a>
      )}
    </div>
  );
}

function titleOf(lesson: Lesson): string {
  return lesson.title || words.value.lessons.untitled;
}
