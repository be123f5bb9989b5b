import { BookOpen, Square } from "lucide-preact";
import { useEffect, useState } from "preact/hooks";
import { classesApi, NO_CLASS } from "../api/classes";
import type { Lesson } from "../api/model";
import { classroom, groupsIn, shownClass } from "../app/classroom";
import { hashOf } from "../app/route";
import { report } from "../app/session";
import { asTeacher } from "../app/teacher";
import { TEST } from "../app/testids";
import { ClassChips } from "../screens/ClassChips";
import { useAct } from "./act";
import { useActivities } from "./activities";
import { FaultLine } from "./FaultLine";
import { LessonList } from "./LessonList";
import { momentOf } from "./moments";
import { OpenLesson } from "./OpenLesson";
import type { School } from "./TeacherScreen";
import { words } from "./words";

/** What each class is about now, and has been about. */
export function LessonsPart({ school: { classes, groups } }: { school: School }) {
  const { lessons: say } = words.value;
  const shown = shownClass(classroom.value, classes, groups);
  const withNone = groupsIn(NO_CLASS, groups).length > 0;
  if (classes.length === 0) {
    return (
      <>
        <h1>{say.title}</h1>
        <p class="teacher__hint">{say.noClasses}</p>
        <a class="button button--run" href={hashOf({ screen: "teacher", part: "classes" })}>
          {say.makeClass}
        </a>
        {withNone && <ClassLessons id={NO_CLASS} />}
      </>
    );
  }
  return (
    <>
      <h1>{say.title}</h1>
      <ClassChips classes={classes} withNone={withNone} shown={shown} />
      <ClassLessons key={shown} id={shown} />
    </>
  );
}

interface Found {
  lessons: Lesson[];
  current: Lesson | null;
}

function ClassLessons({ id }: { id: string }) {
  const [found, setFound] = useState<Found | null>(null);
  const isClass = id !== NO_CLASS;
  const reload = async () => {
    const [lessons, current] = await Promise.all([
      asTeacher(() => classesApi.lessons(id)),
      isClass ? classesApi.currentLesson(id) : null,
    ]);
    setFound({ lessons, current });
  };
  useEffect(() => {
    reload().catch(report);
  }, [id]);
  if (!found) return null;
  const open = found.current?.by_itself === false ? found.current : null;
  return (
    <>
      {isClass && (
        <section class="panel card">
          {open ? (
            <OpenNow lesson={open} onClosed={reload} />
          ) : (
            <p class="teacher__hint">
              {found.current ? words.value.lessons.byItself : words.value.lessons.none}
            </p>
          )}
          <OpenLesson classroom={id} another={open !== null} onOpened={reload} />
        </section>
      )}
      <LessonList lessons={found.lessons} onChanged={reload} />
    </>
  );
}

interface OpenNowProps {
  lesson: Lesson;
  onClosed(): Promise<void>;
}

function OpenNow({ lesson, onClosed }: OpenNowProps) {
  const { lessons: say } = words.value;
  const { busy, fault, act } = useAct();
  const activity = useActivities().find((one) => one.name === lesson.activity);
  const since = say.since(momentOf(lesson.opened_at));
  const close = async () => {
    await classesApi.changeLesson(lesson.id, { closed: true });
    await onClosed();
  };
  return (
    <div class="lesson-now" data-testid={TEST.lessonNow}>
      <BookOpen class="icon lesson-now__icon" aria-hidden="true" />
      <p class="lesson-now__words">
        <span>
          {say.now} · {since}
        </span>
        <strong class="lesson-now__title">{lesson.title}</strong>
        {activity && <span>{activity.title}</span>}
      </p>
      <button
        type="button"
        class="button"
        disabled={busy}
        data-testid={TEST.closeLesson}
        onClick={() => void act(close)}
      >
        <Square class="icon" fill="currentColor" aria-hidden="true" />
        {say.close}
      </button>
      <FaultLine fault={fault} />
    </div>
  );
}
