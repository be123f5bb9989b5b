import type { Language } from "../i18n/language";
import { ApiError, ServerGone } from "./errors";
import type {
  Content,
  Debugging,
  Evaluated,
  Fault,
  Group,
  Program,
  ProgramWithVersion,
  ReadPython,
  Ring,
  Run,
  RunEvent,
  RunList,
  RunWithVersion,
  SavedVersion,
  Status,
  StepMode,
  World,
  WrittenPython,
} from "./model";

/** A keepalive request may carry no more than this, by the fetch standard. */
const KEEPALIVE_LIMIT = 60_000;

type Method = "GET" | "POST" | "PUT" | "PATCH" | "DELETE";

function request(method: Method, path: string, body?: object, last = false): Promise<Response> {
  const init: RequestInit = { method };
  if (body) {
    init.headers = { "Content-Type": "application/json" };
    init.body = JSON.stringify(body);
    init.keepalive = last && init.body.length < KEEPALIVE_LIMIT;
  }
  return ask(path, init);
}

async function ask(path: string, init: RequestInit): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(path, init);
  } catch (error) {
    throw new ServerGone(String(error));
  }
  if (!response.ok) throw await errorOf(response);
  return response;
}

/** A file of the server. */
export async function octets(path: string): Promise<Blob> {
  return (await ask(path, {})).blob();
}

/** Sends a file as it is. */
export async function sendFile<T>(path: string, file: Blob): Promise<T> {
  const headers = { "Content-Type": "application/octet-stream" };
  return (await ask(path, { method: "POST", headers, body: file })).json();
}

async function errorOf(response: Response): Promise<ApiError> {
  const answer = await response.json().catch(() => ({}));
  return new ApiError(response.status, answer?.error ?? {});
}

/** Asks the server; throws ApiError with its words, or ServerGone. The parts of `api/` build on it. */
export async function json<T>(
  method: Method,
  path: string,
  body?: object,
  last = false,
): Promise<T> {
  const response = await request(method, path, body, last);
  return (await response.json()) as T;
}

export const api = {
  status: () => json<Status>("GET", "/api/status"),
  setLanguage: (language: Language) =>
    json<{ language: Language }>("PUT", "/api/settings", { language }),

  groups: async () => (await json<{ groups: Group[] }>("GET", "/api/groups")).groups,

  programs: async (group: string) =>
    (await json<{ programs: Program[] }>("GET", `/api/groups/${group}/programs`)).programs,
  createProgram: (group: string, name: string) =>
    json<Program>("POST", `/api/groups/${group}/programs`, { name }),
  program: (id: string) => json<ProgramWithVersion>("GET", `/api/programs/${id}`),
  renameProgram: (id: string, name: string) =>
    json<Program>("PATCH", `/api/programs/${id}`, { name }),
  /** `last`: the page is closing, the request must outlive it. */
  saveVersion: (program: string, content: Content, last = false) =>
    json<SavedVersion>("POST", `/api/programs/${program}/versions`, content, last),

  runs: (group: string, before: string | null = null, limit = 50) =>
    json<RunList>(
      "GET",
      `/api/groups/${group}/runs?limit=${limit}${before ? `&before=${before}` : ""}`,
    ),
  startRun: (versionId: string, world: string, debugging: Debugging) =>
    json<Run>("POST", "/api/runs", { version_id: versionId, world, ...debugging }),
  step: (run: string, mode: StepMode) => json<object>("POST", `/api/runs/${run}/step`, { mode }),
  setBreakpoints: (run: string, blocks: readonly string[]) =>
    json<object>("PUT", `/api/runs/${run}/breakpoints`, { blocks }),
  evaluate: (run: string, expression: unknown) =>
    json<Evaluated>("POST", `/api/runs/${run}/evaluate`, { expression }),
  setSpeed: (run: string, factor: number) =>
    json<object>("PUT", `/api/runs/${run}/speed`, { factor }),
  look: (run: string, sensors: readonly Ring[]) =>
    json<object>("PUT", `/api/runs/${run}/look`, { sensors }),
  pause: (run: string) => json<object>("POST", `/api/runs/${run}/pause`),
  resume: (run: string) => json<object>("POST", `/api/runs/${run}/resume`),
  stop: (run: string) => json<object>("POST", `/api/runs/${run}/stop`),
  answerCapture: (run: string, result: string) =>
    json<object>("POST", `/api/runs/${run}/capture`, { result }),
  answerQuestion: (run: string, value: string) =>
    json<object>("POST", `/api/runs/${run}/answer`, { value }),
  writePython: (document: object) => json<WrittenPython>("POST", "/api/python", { document }),
  readPython: (text: string) => json<ReadPython>("POST", "/api/python/read", { text }),

  run: (id: string) => json<RunWithVersion>("GET", `/api/runs/${id}`),
  runEvents: async (id: string) =>
    (await json<{ events: RunEvent[] }>("GET", `/api/runs/${id}/events`)).events,
  runTelemetry: async (id: string) =>
    (await request("GET", `/api/runs/${id}/telemetry`)).arrayBuffer(),

  worlds: async () => (await json<{ worlds: World[] }>("GET", "/api/worlds")).worlds,
  /** Everything that is wrong with a world, in words. */
  checkWorld: async (world: unknown) =>
    (await json<{ faults: Fault[] }>("POST", "/api/worlds/check", { world })).faults,
};
