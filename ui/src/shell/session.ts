import { computed, effect, signal } from "@preact/signals";
import { api } from "../api/client";
import { ApiError, ServerGone } from "../api/errors";
import type {
  Group,
  JudgedEvent,
  Notice,
  Program,
  ProgramChangedEvent,
  RunEvent,
  Status,
  StreamEvent,
  World,
} from "../api/model";
import { type Language, language, speak, texts } from "../i18n";
import { isLanguage } from "../i18n/languages";
import { reportTo } from "../kit/report";
import { type Problem, wordsOf } from "../kit/requests/problem";
import { serverStatus } from "./first_answers";
import { remember } from "./remembered";
import { ROUTES, route, staying } from "./route";
import { openStream } from "./stream";

/** How the page stands with the program behind it. */
export type Connection = "opening" | "failed" | "open" | "gone" | "locked";

export const connection = signal<Connection>("opening");
export const status = signal<Status | null>(null);
export const notice = signal<Notice | null>(null);
/** Whether the run that ended last passed the activity of its lesson. */
export const judged = signal<JudgedEvent | null>(null);
/** What was saved last, or went into the bin or came out of it, in any window. */
export const changed = signal<ProgramChangedEvent | null>(null);
export const problem = signal<Problem | null>(null);
export const worlds = signal<World[]>([]);

/** Group and program in the header, whatever the screen. */
export const group = signal<Group | null>(null);
export const program = signal<Program | null>(null);

/** Without the server, another screen would be an empty one. */
effect(() => {
  staying.value = connection.value === "gone";
});

export const engine = computed(() => status.value?.engine ?? "starting");

/** Read by the server too, which writes the page before it has opened the store. */
const LANGUAGE_COOKIE = "pinel_language";
const POLL_MS = 1000;
// said once, then what the server says of itself is shown again
const GOOD_NEWS = new Set(["recording_resumed", "keeping_well_again"]);
const GOOD_NEWS_MS = 8000;

/** An error in words, in the line under the header; 401 and a lost server have their own places. */
export function report(error: unknown): void {
  if (error instanceof ServerGone) lost();
  else if (error instanceof ApiError && error.status === 401) connection.value = "locked";
  else problem.value = wordsOf(error);
}
reportTo(report);

let polling = 0;

function lost(): void {
  if (connection.value !== "locked") connection.value = "gone";
  poll();
}

function poll(): void {
  if (!polling) {
    polling = window.setTimeout(() => {
      polling = 0;
      void refreshStatus();
    }, POLL_MS);
  }
}

/** Asks the server how it is; goes on asking while it is gone or its engine is not ready. */
export async function refreshStatus(): Promise<void> {
  try {
    const answer = await serverStatus();
    if (["opening", "failed"].includes(connection.value) && isLanguage(answer.language)) {
      await speak(answer.language);
    }
    status.value = answer;
    notice.value = answer.database.notice;
    connection.value = "open";
    if (answer.engine !== "ready") poll();
  } catch (error) {
    report(error);
    if (connection.value === "opening") connection.value = "failed";
  }
}

let languageKept: Promise<unknown> = Promise.resolve();

export async function chooseLanguage(chosen: Language): Promise<void> {
  // one after the other: of two answers on their way the server would keep whichever comes last
  languageKept = languageKept.then(() => api.setLanguage(chosen));
  try {
    await Promise.all([languageKept, speak(chosen)]);
    if (notice.value) await refreshStatus();
  } catch (error) {
    languageKept = Promise.resolve();
    report(error);
  }
}

/** Who follows the runs. */
interface Follower {
  receive(event: RunEvent): void;
  /** The stream begins, or begins again: what was missed of the run is to be asked for. */
  resync(run: string | null): Promise<void>;
}

function onStream(event: StreamEvent, runs: Follower): void {
  switch (event.type) {
    case "hello":
      void refreshStatus();
      void runs.resync(event.run).catch(report);
      break;
    case "notice":
      notice.value = event;
      if (GOOD_NEWS.has(event.code)) window.setTimeout(() => void refreshStatus(), GOOD_NEWS_MS);
      break;
    case "judged":
      judged.value = event;
      break;
    case "program":
      changed.value = event;
      break;
    default:
      runs.receive(event);
      if (event.type === "run_ended" && event.state === "failed") void refreshStatus();
  }
}

window.addEventListener("hashchange", () => {
  problem.value = null;
});

/** "Quadrado · Histórico · PINEL". */
function title(): string {
  const { screen } = route.value;
  const about = ROUTES[screen].ofGroup ? program.value?.name : null;
  return [about, texts.value.titles[screen], "PINEL"].filter(Boolean).join(" · ");
}

/** Opens the page's line to the server, once the texts of the first language are there. */
export async function open(runs: Follower): Promise<void> {
  effect(() => {
    document.documentElement.lang = language.value;
    remember(LANGUAGE_COOKIE, language.value);
  });
  effect(() => {
    document.title = title();
  });
  await refreshStatus();
  if (connection.value === "locked") return;
  openStream({ onEvent: (event) => onStream(event, runs), onLost: () => void refreshStatus() });
  try {
    worlds.value = await api.worlds();
  } catch (error) {
    report(error);
  }
}
