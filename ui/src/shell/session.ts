import { computed, effect, signal } from "@preact/signals";
import { api } from "../api/client";
import { ApiError, ServerGone } from "../api/errors";
import type {
  Group,
  JudgedEvent,
  Notice,
  Program,
  ProgramEvent,
  Status,
  StreamEvent,
  World,
} from "../api/model";
import { language, texts } from "../i18n";
import { isLanguage, type Language } from "../i18n/language";
import { live, receive, resync } from "../run/live";
import { openStream } from "../run/stream";
import { serverStatus } from "./first_answers";
import { staying } from "./route";

/** How the page stands with the program behind it. */
export type Connection = "opening" | "open" | "gone" | "locked";

export interface Problem {
  message: string;
  remedy: string;
}

export const connection = signal<Connection>("opening");
export const status = signal<Status | null>(null);
export const notice = signal<Notice | null>(null);
/** Whether the run that ended last passed the activity of its lesson. */
export const judged = signal<JudgedEvent | null>(null);
/** What was saved last, or went into the bin or came out of it, in any window. */
export const changed = signal<ProgramEvent | null>(null);
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

/** What the page itself cannot do, in words. */
export class Refused extends Error {
  constructor(
    message: string,
    readonly remedy: string,
  ) {
    super(message);
  }
}

export function wordsOf(error: unknown): Problem {
  if (error instanceof Refused) return { message: error.message, remedy: error.remedy };
  if (error instanceof ApiError && error.message) {
    return { message: error.message, remedy: error.remedy };
  }
  const { trouble } = texts.value;
  if (error instanceof ServerGone) return { message: trouble.goneTitle, remedy: trouble.gone };
  return { message: trouble.failedTitle, remedy: "" };
}

let polling = 0;

function lost(): void {
  if (connection.value === "open" || connection.value === "opening") connection.value = "gone";
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
    status.value = answer;
    notice.value = answer.database.notice;
    if (connection.value === "opening" && isLanguage(answer.language)) {
      language.value = answer.language;
    }
    connection.value = "open";
    if (answer.engine !== "ready") poll();
  } catch (error) {
    report(error);
  }
}

let languageKept: Promise<unknown> = Promise.resolve();

export async function chooseLanguage(chosen: Language): Promise<void> {
  language.value = chosen;
  // one after the other: of two answers on their way the server would keep whichever comes last
  languageKept = languageKept.then(() => api.setLanguage(chosen));
  try {
    await languageKept;
    if (notice.value) await refreshStatus();
  } catch (error) {
    languageKept = Promise.resolve();
    report(error);
  }
}

function onStream(event: StreamEvent): void {
  switch (event.type) {
    case "hello":
      void refreshStatus();
      void resync(event.run).catch(report);
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
      receive(event);
      if (event.type === "run_ended" && event.state === "failed") void refreshStatus();
  }
}

window.addEventListener("hashchange", () => {
  problem.value = null;
});

/** Opens the page's line to the server. */
export async function open(): Promise<void> {
  effect(() => {
    document.documentElement.lang = language.value;
    document.title = program.value ? `${program.value.name} · PINEL` : "PINEL";
  });
  await refreshStatus();
  if (connection.value === "locked") return;
  openStream({ onEvent: onStream, onLost: () => void refreshStatus() });
  try {
    worlds.value = await api.worlds();
  } catch (error) {
    report(error);
  }
}

export const isRunning = computed(() =>
  ["starting", "running", "paused"].includes(live.value.phase),
);
