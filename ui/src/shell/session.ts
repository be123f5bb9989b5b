import { computed, effect, signal } from "@preact/signals";
import { api } from "../api/client";
import { ApiError, ServerUnreachable } from "../api/errors";
import type {
  CameraChangedEvent,
  CameraSightEvent,
  CheckStatusChangedEvent,
  CloudProgressEvent,
  Group,
  JudgedEvent,
  Notice,
  Program,
  ProgramChangedEvent,
  Robot,
  RobotStateChangedEvent,
  RunEvent,
  SignRecordingEvent,
  SignsChangedEvent,
  Status,
  StreamEvent,
  TruthSourceChangedEvent,
  World,
} from "../api/model";
import { type Language, language, setLanguage, texts } from "../i18n";
import { isLanguage } from "../i18n/languages";
import { reportTo } from "../kit/report";
import { type Problem, problemOf } from "../kit/requests/problem";
import { serverStatus } from "./first_answers";
import { go, navigationBlocked, ROUTES, route } from "./route";
import { choose, setting } from "./settings";
import { openStream } from "./stream";

/** State of the connection to the server. */
export type Connection = "opening" | "failed" | "open" | "gone" | "locked";

export const connection = signal<Connection>("opening");
export const status = signal<Status | null>(null);
export const notice = signal<Notice | null>(null);
/** Verdict on the last run by the activity of its lesson. */
export const judged = signal<JudgedEvent | null>(null);
/** Status of the activity's checks in the live run. */
export const checkStatus = signal<CheckStatusChangedEvent | null>(null);
/** The last program saved, discarded or restored, in any window. */
export const changed = signal<ProgramChangedEvent | null>(null);
/** The last robots of a cloud that have arrived. */
export const cloud = signal<CloudProgressEvent | null>(null);
export const problem = signal<Problem | null>(null);
export const worlds = signal<World[]>([]);
/** The robot models that the server knows, the default first; empty until they are loaded. */
export const robotModels = signal<readonly Robot[]>([]);

/**
 * The description of a robot model. Null and a model of a newer release give the default model.
 * Returns null until the models are loaded.
 */
export function robotOf(model: string | null | undefined): Robot | null {
  const { value: models } = robotModels;
  return models.find(({ name }) => name === model) ?? models[0] ?? null;
}

/** Group and program in the header of all screens. */
export const group = signal<Group | null>(null);
export const program = signal<Program | null>(null);

// without the server another screen would stay empty
effect(() => {
  navigationBlocked.value = connection.value === "gone";
});

export const engine = computed(() => status.value?.engine ?? "starting");

const POLL_MS = 1000;
// shown for `GOOD_NEWS_MS`, then replaced by the server's current notice
const GOOD_NEWS = new Set(["recording_resumed", "keeping_well_again"]);
const GOOD_NEWS_MS = 8000;

/** Shows an error in the line under the header; other parts show 401 and an unreachable server. */
export function report(error: unknown): void {
  if (error instanceof ServerUnreachable) lost();
  else if (error instanceof ApiError && error.status === 401) connection.value = "locked";
  else problem.value = problemOf(error);
}
reportTo(report);

let polling = 0;
/** Number of the last failure to reach the server, in the order of the requests of the status. */
let lostNumber = 0;

function lost(): void {
  lostNumber = ++lastNumber;
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

/** Numbers requests of the status, and notices from elsewhere, in their order. */
let lastNumber = 0;
/** Number of the shown notice. */
let shownNumber = 0;

/** Shows a notice. The response to an earlier request of the status does not replace it. */
export function showNotice(shown: Notice | null, number = ++lastNumber): void {
  if (number < shownNumber) return;
  shownNumber = number;
  notice.value = shown;
}

/** Loads the server's status; polls while the server is unreachable or its engine is not ready. */
export async function refreshStatus(): Promise<void> {
  const number = ++lastNumber;
  try {
    const answer = await serverStatus();
    const isFirst = ["opening", "failed"].includes(connection.value);
    // if a person chose a language before the first response, the choice takes precedence
    if (isFirst && !languageChosen && isLanguage(answer.language))
      await setLanguage(answer.language);
    status.value = answer;
    showNotice(answer.database.notice, number);
    // a response to a request from before the failure does not show that the server is there again
    if (number > lostNumber) connection.value = "open";
    if (answer.engine !== "ready") poll();
  } catch (error) {
    report(error);
    if (connection.value === "opening") connection.value = "failed";
  }
}

/** Whether a person chose the language of this page. */
let languageChosen = false;

export async function chooseLanguage(chosen: Language): Promise<void> {
  languageChosen = true;
  try {
    await Promise.all([choose("pinel_language", chosen), setLanguage(chosen)]);
    if (notice.value) await refreshStatus();
  } catch (error) {
    report(error);
  }
}

/** Applies the language chosen last: the server may have served the page before it had that choice. */
async function speakChosen(): Promise<void> {
  const chosen = setting("pinel_language").peek();
  if (chosen && chosen !== language.peek()) await chooseLanguage(chosen);
}

/** Receiver of the events of runs. */
interface RunEventHandler {
  receive(event: RunEvent): void;
  /** Requests the missed events of the run, after the stream has connected or reconnected. */
  resync(run: string | null): Promise<void>;
}

/** Receiver of the events of the camera. */
interface CameraEventHandler {
  receive(
    event: CameraSightEvent | CameraChangedEvent | SignRecordingEvent | SignsChangedEvent,
  ): void;
  /** Requests the camera's state, after the stream has connected or reconnected. */
  resync(): Promise<void>;
}

/** Receiver of the states of the real robots that this page watches, and of the sources of truth of their runs. */
type RobotEventHandler = (event: RobotStateChangedEvent | TruthSourceChangedEvent) => void;

function onStream(
  event: StreamEvent,
  runs: RunEventHandler,
  camera: CameraEventHandler,
  robots: RobotEventHandler,
): void {
  switch (event.type) {
    case "hello":
      void refreshStatus();
      void runs.resync(event.run).catch(report);
      void camera.resync().catch(report);
      break;
    case "camera_sight":
    case "camera_state":
    case "sign_recording":
    case "signs_changed":
      camera.receive(event);
      break;
    case "robot_state":
    case "truth_source":
      robots(event);
      break;
    case "notice":
      showNotice(event);
      if (GOOD_NEWS.has(event.code)) window.setTimeout(() => void refreshStatus(), GOOD_NEWS_MS);
      break;
    case "checks_stand":
      checkStatus.value = event;
      break;
    case "cloud":
      cloud.value = event;
      break;
    case "judged":
      judged.value = event;
      break;
    case "program":
      changed.value = event;
      break;
    case "file_opened":
      go({ screen: "teacher", part: "files" });
      break;
    default:
      runs.receive(event);
      if (event.type === "run_ended" && event.state === "failed") void refreshStatus();
  }
}

window.addEventListener("hashchange", () => {
  problem.value = null;
});

/** The title of the window, such as "Quadrado · Histórico · PINEL". */
function title(): string {
  const { screen } = route.value;
  const about = ROUTES[screen].ofGroup ? program.value?.name : null;
  return [about, texts.value.titles[screen], "PINEL"].filter(Boolean).join(" · ");
}

/** Opens the connection to the server, after the texts of the first language have loaded. */
export async function open(
  runs: RunEventHandler,
  camera: CameraEventHandler,
  robots: RobotEventHandler,
): Promise<void> {
  effect(() => {
    document.documentElement.lang = language.value;
  });
  effect(() => {
    document.title = title();
  });
  void speakChosen();
  await refreshStatus();
  if (connection.value === "locked") return;
  openStream({
    onEvent: (event) => onStream(event, runs, camera, robots),
    onLost: () => void refreshStatus(),
  });
  try {
    [worlds.value, robotModels.value] = await Promise.all([api.worlds(), api.robots()]);
  } catch (error) {
    report(error);
  }
}
