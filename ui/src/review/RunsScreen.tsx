import { type Signal, signal, useSignal, useSignalEffect } from "@preact/signals";
import { ArrowLeft, Columns2, X } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { classesApi } from "../api/classes";
import { api } from "../api/client";
import { type RunFilter, reviewApi } from "../api/review";
import { hashOf } from "../app/route";
import { report } from "../app/session";
import { asTeacher } from "../app/teacher";
import { TEST } from "../app/testids";
import { words } from "../i18n/review";
import { Behind } from "./Behind";
import { HistoryCard } from "./HistoryCard";
import type { HistoryRun } from "./model";
import { Refresh } from "./Refresh";
import { NO_FILTER, RunFilters, type School } from "./RunFilters";
import { useScrollPlace } from "./scroll_place";
import { useSeen } from "./seen";

/** What was chosen last stays for as long as the page is open: a replay is a step away and back. */
const filter = signal<RunFilter>(NO_FILTER);
const chosen = signal<readonly HistoryRun[]>([]);
interface RunPage {
  runs: HistoryRun[];
  next: string | null;
}

const place = { top: 0, runs: 0, filter: NO_FILTER };

/** Runs of all groups, newest first, for the teacher. */
export function RunsScreen() {
  return (
    <Behind>
      <Runs />
    </Behind>
  );
}

function Runs() {
  const texts = words.value.runs;
  const school = useSignal<School>({ classrooms: [], groups: [], activities: [] });
  const list = useRunList(filter);
  const main = useScrollPlace(place, list.shown.value !== null);
  useEffect(() => {
    askSchool().then((found) => {
      school.value = found;
    }, report);
  }, []);
  return (
    <main class="screen runs" ref={main} data-testid={TEST.historyPage}>
      <div class="runs__head">
        <a
          class="button button--icon"
          href={hashOf({ screen: "teacher", part: "lessons" })}
          aria-label={words.value.lesson.back}
          title={words.value.lesson.back}
        >
          <ArrowLeft class="icon" aria-hidden="true" />
        </a>
        <h1>{texts.title}</h1>
        <p>{texts.help}</p>
        {list.at.value && (
          <Refresh at={list.at.value} busy={list.busy.value} onRefresh={list.again} />
        )}
      </div>
      <RunFilters filter={filter} school={school.value} />
      {list.shown.value?.runs.length === 0 && (
        <div class="lesson__empty" data-testid={TEST.historyEmpty}>
          <strong>{isFiltered(filter.value) ? texts.emptyTitle : texts.noneTitle}</strong>
          <p>{isFiltered(filter.value) ? texts.empty : texts.none}</p>
        </div>
      )}
      <ul class="work__cards runs__cards" aria-busy={list.busy.value}>
        {list.shown.value?.runs.map((run) => (
          <li key={run.id}>
            <HistoryCard run={run} chosen={chosen} />
          </li>
        ))}
      </ul>
      {list.shown.value?.next && (
        <button
          type="button"
          class="button work__older"
          data-testid={TEST.historyOlder}
          onClick={list.older}
        >
          {texts.older}
        </button>
      )}
      <Chosen />
    </main>
  );
}

const isFiltered = (wanted: RunFilter) => Object.values(wanted).some(Boolean);

async function askSchool(): Promise<School> {
  const [classrooms, groups, activities] = await Promise.all([
    classesApi.classrooms(),
    api.groups(),
    classesApi.activities(),
  ]);
  return { classrooms, groups, activities };
}

/** The list of the filter that is on, a page at a time. */
function useRunList(of: Signal<RunFilter>) {
  const wanted = of.value;
  const { seen, busy, again } = useSeen(wanted, () =>
    runsOf(wanted, place.filter === wanted ? place.runs : 0),
  );
  const shown = useSignal<RunPage | null>(null);
  const at = useSignal<Date | null>(null);
  useSignalEffect(() => {
    if (!seen.value) return;
    show(seen.value.what);
    at.value = seen.value.at;
  });
  const show = (page: RunPage) => {
    shown.value = page;
    Object.assign(place, { filter: of.peek(), runs: page.runs.length });
  };
  const older = () => {
    const before = shown.value;
    if (!before) return;
    void asTeacher(() => reviewApi.runs(wanted, before.next)).then((page) => {
      if (shown.value === before) show({ ...page, runs: [...before.runs, ...page.runs] });
    }, report);
  };
  return { shown, at, busy, again, older };
}

/** The newest runs: a page of them, or as many pages as were shown before. */
async function runsOf(wanted: RunFilter, least: number): Promise<RunPage> {
  let { runs, next } = await reviewApi.runs(wanted, null);
  while (next && runs.length < least) {
    const page = await reviewApi.runs(wanted, next);
    runs = [...runs, ...page.runs];
    next = page.next;
  }
  return { runs, next };
}

/** What is chosen for side by side, at the bottom of the screen. */
function Chosen() {
  const texts = words.value.runs;
  const [first, second] = chosen.value;
  if (!first) return null;
  return (
    <div class="runs__chosen card" role="status">
      <span>{second ? texts.twoChosen : texts.oneChosen}</span>
      <button
        type="button"
        class="button"
        onClick={() => {
          chosen.value = [];
        }}
      >
        <X class="icon" aria-hidden="true" />
        {texts.forget}
      </button>
      {second && (
        <a
          class="button button--run"
          href={hashOf({ screen: "compare", runs: [first.id, second.id] })}
          data-testid={TEST.compareOpen}
        >
          <Columns2 class="icon" aria-hidden="true" />
          {texts.compare}
        </a>
      )}
    </div>
  );
}
