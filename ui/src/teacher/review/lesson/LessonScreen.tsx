import type { ComponentChildren } from "preact";
import { useEffect } from "preact/hooks";
import type { TimelineEntry } from "../../../api/model";
import { language, texts } from "../../../i18n";
import { Loaded } from "../../../kit/requests/Loaded";
import { valueIn } from "../../../kit/requests/load_state";
import { useScrollPosition } from "../../../kit/scroll_position";
import { usePolling } from "../../../kit/usePolling";
import type { ParametersOf } from "../../../shell/route";
import { RequireTeacher } from "../../sign_in/RequireTeacher";
import { useTeacherLoaded } from "../../useTeacherLoaded";
import { EmptyList } from "../EmptyList";
import { Refresh } from "../Refresh";
import { TipBubble } from "../timeline_entries/TipBubble";
import { useUnusualRuns } from "../unusual_runs";
import { Explanations } from "./Explanations";
import { GroupList } from "./GroupList";
import { Legend } from "./Legend";
import { LessonHead } from "./LessonHead";
import { viewStateOf } from "./lesson_view_state";
import { type LessonPage, loadLesson } from "./load_lesson";

/** The review of a lesson: a timeline for each group. */
export function LessonScreen({ lesson }: ParametersOf<"lesson">) {
  return (
    <RequireTeacher>
      <LoadedLesson lessonId={lesson} />
    </RequireTeacher>
  );
}

function LoadedLesson({ lessonId }: { lessonId: string }) {
  const page = useTeacherLoaded(`${lessonId} ${language.value}`, () => loadLesson(lessonId));
  const isWaiting =
    valueIn(page)?.review.groups.some(({ entries }) => entries.some(waits)) ?? false;
  // reloads without a loading state, so that open rows do not move; after a failure, the next poll tries again
  const reload = () => loadLesson(lessonId).then(page.set, () => {});
  usePolling(reload, { isOn: isWaiting });
  useUnusualRuns();
  useEffect(() => {
    document.documentElement.dataset.page = "lesson"; // for print.css
    return () => {
      delete document.documentElement.dataset.page;
    };
  }, []);
  return (
    <Loaded of={page} as="screen" loading={texts.value.review.lesson.opening}>
      {(value, { at, busy }) => (
        <Lesson
          page={value}
          refresh={<Refresh at={at} busy={busy} onRefresh={page.reload} />}
          onAccepted={reload}
        />
      )}
    </Loaded>
  );
}

/** Whether a merged run awaits re-verification on this PC. */
const waits = ({ unconfirmed }: TimelineEntry) => unconfirmed === "waiting";

interface LessonProps {
  page: LessonPage;
  refresh: ComponentChildren;
  /** Called after the teacher accepted a run that this PC cannot repeat. */
  onAccepted(): unknown;
}

function Lesson({ page, refresh, onAccepted }: LessonProps) {
  const { lesson: labels } = texts.value.review;
  const { groups, lesson } = page.review;
  const viewState = viewStateOf(lesson.id);
  const main = useScrollPosition(viewState, true);
  const hasRuns = groups.some(({ figures }) => figures.n_runs > 0);
  return (
    <main class="screen lesson" ref={main} data-testid="lesson-page">
      <LessonHead page={page} viewState={viewState} refresh={refresh} />
      {groups.length === 0 ? (
        <EmptyList title={labels.emptyTitle} text={labels.empty} testId="lesson-empty" />
      ) : (
        <>
          <Legend />
          {!hasRuns && (
            <p class="review-empty review-empty--low">
              <strong>{labels.noRunsTitle}.</strong> {labels.noRuns}
            </p>
          )}
          <GroupList review={page.review} viewState={viewState} onAccepted={onAccepted} />
          <Explanations />
        </>
      )}
      <TipBubble />
    </main>
  );
}
