import { BookOpen } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { language, texts } from "../../i18n";
import { usePolling } from "../../kit/usePolling";
import { isRunning } from "../../run/live";
import { lesson, loadOpenLesson } from "../../shell/lesson";
import { group } from "../../shell/session";
import { LessonGoal } from "./LessonGoal";

/** Polls because the teacher may open a lesson in another window while the group works. */
const EVERY_MS = 15_000;

/** Title and activity of the open lesson. */
export function LessonChip() {
  const classroom = group.value?.classroom_id ?? null;
  // also before each run, because a run is graded by the activity of the lesson
  useEffect(() => void loadOpenLesson(), [classroom, language.value, isRunning.value]);
  usePolling(loadOpenLesson, { everyMs: EVERY_MS });
  const now = lesson.value;
  if (!now) return null;
  const whole = [texts.value.classes.lesson({ title: now.title }), now.activity]
    .filter(Boolean)
    .join(" · ");
  return (
    <div class="lesson-chip row middle gap-2" title={whole} data-testid="lesson-chip">
      {now.goal ? (
        <LessonGoal activity={now.activity || now.title} goal={now.goal} />
      ) : (
        <BookOpen class="icon" aria-hidden="true" />
      )}
      <p class="lesson-chip__words column center shrinks">
        <span class="lesson-chip__title" data-shortened>
          {now.title}
        </span>
        {now.activity && (
          <span class="lesson-chip__activity aside" data-shortened>
            {now.activity}
          </span>
        )}
      </p>
    </div>
  );
}
