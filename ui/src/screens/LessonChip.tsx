import { BookOpen } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { knowLesson, lesson } from "../app/lesson";
import { group } from "../app/session";
import { TEST } from "../app/testids";
import { language, texts } from "../i18n";

/** What today is about: the open lesson's title and its activity. */
export function LessonChip() {
  const classroom = group.value?.classroom_id ?? null;
  useEffect(() => {
    const look = () => document.visibilityState === "visible" && void knowLesson();
    look();
    // the teacher may open one in another window
    document.addEventListener("visibilitychange", look);
    return () => document.removeEventListener("visibilitychange", look);
  }, [classroom, language.value]);
  const now = lesson.value;
  if (!now) return null;
  const whole = [texts.value.classes.lesson(now.title), now.activity].filter(Boolean).join(" · ");
  return (
    <p class="lesson-chip" title={whole} data-testid={TEST.lessonChip}>
      <BookOpen class="icon" aria-hidden="true" />
      <span class="lesson-chip__words">
        <span class="lesson-chip__title" data-shortened>
          {now.title}
        </span>
        {now.activity && (
          <span class="lesson-chip__activity" data-shortened>
            {now.activity}
          </span>
        )}
      </span>
    </p>
  );
}
