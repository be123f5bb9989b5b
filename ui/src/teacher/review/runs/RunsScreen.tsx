import type { HistoryRun, Lesson } from "../../../api/model";
import { language, texts } from "../../../i18n";
import { Button } from "../../../kit/Button";
import { Loaded } from "../../../kit/requests/Loaded";
import { useScrollPosition } from "../../../kit/scroll_position";
import { RequireTeacher } from "../../sign_in/RequireTeacher";
import { useTeacherLoaded } from "../../useTeacherLoaded";
import { BackToLessons } from "../BackToLessons";
import { EmptyList } from "../EmptyList";
import { Refresh } from "../Refresh";
import { useUnusualRuns } from "../unusual_runs";
import { ChosenRuns } from "./ChosenRuns";
import { HistoryCard } from "./HistoryCard";
import { RunFilters } from "./RunFilters";
import { chosen, filter, left, loadFilterChoices, type RunPage, useRunList } from "./run_list";

/** Runs of all groups, newest first. */
export function RunsScreen() {
  return (
    <RequireTeacher>
      <Runs />
    </RequireTeacher>
  );
}

function Runs() {
  const { runs: labels } = texts.value.review;
  const { list, older } = useRunList();
  useUnusualRuns();
  const choices = useTeacherLoaded(language.value, loadFilterChoices);
  const main = useScrollPosition(left, list.status === "ready");
  return (
    <main
      class={`screen runs ${chosen.value.length > 0 ? "runs--choosing" : ""}`}
      ref={main}
      data-testid="history-page"
    >
      <div class="review-head runs__head row middle gap-4">
        <BackToLessons />
        <h1>{labels.title}</h1>
        <p>{labels.help}</p>
        {list.status === "ready" && (
          <Refresh at={list.at} busy={list.busy} onRefresh={list.reload} />
        )}
      </div>
      <Loaded of={choices}>{(found) => <RunFilters filter={filter} choices={found} />}</Loaded>
      {choices.status !== "loading" && ( // filters that appear later would move a card under a click
        <Loaded of={list}>
          {(page, { busy }) => (
            <RunCards
              page={page}
              lessons={choices.status === "ready" ? choices.value.lessons : []}
              busy={busy}
              onOlder={older}
            />
          )}
        </Loaded>
      )}
      <ChosenRuns chosen={chosen} />
    </main>
  );
}

interface RunCardsProps {
  page: RunPage;
  lessons: readonly Lesson[];
  busy: boolean;
  onOlder(): Promise<void>;
}

function RunCards({ page: { runs, next }, lessons, busy, onOlder }: RunCardsProps) {
  const { runs: labels } = texts.value.review;
  if (runs.length === 0) {
    const isFiltered = Object.values(filter.value).some(Boolean);
    return (
      <EmptyList
        title={isFiltered ? labels.emptyTitle : labels.noneTitle}
        text={isFiltered ? labels.empty : labels.none}
        testId="history-empty"
      />
    );
  }
  return (
    <>
      <ul class="work__cards runs__cards" aria-busy={busy}>
        {runs.map((run) => (
          <li key={run.id}>
            <HistoryCard run={run} chosen={chosen} lesson={titleOf(run, lessons)} />
          </li>
        ))}
      </ul>
      {next && (
        <Button class="work__older" testId="history-older" onPress={onOlder}>
          {labels.older}
        </Button>
      )}
    </>
  );
}

function titleOf({ lesson_id }: HistoryRun, lessons: readonly Lesson[]): string | null {
  const lesson = lessons.find(({ id }) => id === lesson_id);
  return lesson ? lesson.title || texts.value.review.lesson.untitled : null;
}
