import { type Signal, useSignal } from "@preact/signals";
import { classesApi, NO_CLASS } from "../../api/classes";
import { language, texts } from "../../i18n";
import { LinkButton } from "../../kit/LinkButton";
import { Loaded } from "../../kit/requests/Loaded";
import { ClassChips } from "../../shell/ClassChips";
import { classroom, groupsIn, shownClass } from "../../shell/classroom";
import { hashOf } from "../../shell/route";
import type { School } from "../school";
import { useTeacherLoaded } from "../useTeacherLoaded";
import { ClassPreset } from "./ClassPreset";
import { CurrentLesson } from "./CurrentLesson";
import { LessonFile } from "./LessonFile";
import { LessonList } from "./LessonList";

interface LessonsPartProps {
  school: School;
  reload(): Promise<void>;
}

/** The open lesson of each class, and its earlier lessons. */
export function LessonsPart({ school: { classes, groups }, reload }: LessonsPartProps) {
  const { lessons: labels } = texts.value.teacher;
  const shown = shownClass(classroom.value, classes, groups);
  const withNone = groupsIn(NO_CLASS, groups).length > 0;
  const opened = useSignal(""); // outlives the class shown, which the opened lesson changes
  if (classes.length === 0) {
    return (
      <>
        <h1>{labels.title}</h1>
        <p class="teacher__hint">{labels.noClasses}</p>
        <LinkButton kind="main" href={hashOf({ screen: "teacher", part: "classes" })}>
          {labels.makeClass}
        </LinkButton>
        <LessonFile lesson={null} status={opened} onOpened={reload} />
        {withNone && <ClassLessons id={NO_CLASS} opened={opened} />}
      </>
    );
  }
  return (
    <>
      <h1>{labels.title}</h1>
      <ClassChips classes={classes} withNone={withNone} shown={shown} />
      <ClassLessons key={shown} id={shown} opened={opened} />
    </>
  );
}

interface ClassLessonsProps {
  id: string;
  /** Text about the lesson file that was opened last. */
  opened: Signal<string>;
}

function ClassLessons({ id, opened }: ClassLessonsProps) {
  const found = useTeacherLoaded(`${id} ${language.value}`, () => loadLessons(id));
  return (
    <Loaded of={found}>
      {({ lessons, now, activities }) => {
        const current = now?.lesson ?? null;
        const open = current?.by_itself === false ? current : null;
        return (
          <>
            {id !== NO_CLASS && (
              <CurrentLesson
                classroom={id}
                now={now}
                activities={activities}
                onChanged={found.reload}
              />
            )}
            <LessonList lessons={lessons} open={current?.id ?? null} onChanged={found.reload} />
            {now && (
              <ClassPreset
                classroom={id}
                preset={now.preset}
                activities={activities}
                onChanged={found.reload}
              />
            )}
            {id !== NO_CLASS && (
              <LessonFile lesson={open} status={opened} onOpened={found.reload} />
            )}
          </>
        );
      }}
    </Loaded>
  );
}

/** Loads the lessons of a class, its open lesson, its preset, and the activities in the language of the page. */
async function loadLessons(id: string) {
  const [lessons, now, activities] = await Promise.all([
    classesApi.lessons(id),
    id === NO_CLASS ? null : classesApi.currentLesson(id),
    classesApi.activities(),
  ]);
  return { lessons, now, activities };
}
