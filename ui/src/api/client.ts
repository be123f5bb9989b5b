import createClient, { type ClientPathsWithMethod, type MaybeOptionalInit } from "openapi-fetch";
import { ApiError, ServerUnreachable } from "./errors";
import type { DocumentToWrite, EditorContent, LiveCommand, NewVersion, RunOptions } from "./model";
import type { paths } from "./types";

/** The one HTTP client. The server's OpenAPI description types paths, parameters and bodies. */
const http = createClient<paths>({
  // Node's Request rejects relative addresses
  baseUrl: location.origin,
  fetch: (request) => globalThis.fetch(request),
});

http.use({
  onError: ({ error }) => (isAbort(error) ? undefined : new ServerUnreachable(String(error))),
  onResponse: async ({ response }) => {
    if (response.ok) return;
    const answer = await response.json().catch(() => ({}));
    throw new ApiError(response.status, answer?.error ?? {});
  },
});

const isAbort = (error: unknown) => error instanceof DOMException && error.name === "AbortError";

type Method = "get" | "post" | "put" | "patch" | "delete";
type Path<M extends Method> = ClientPathsWithMethod<typeof http, M>;
type Init<P extends keyof paths, M extends Method> = MaybeOptionalInit<paths[P], M>;
type ResponseBody<Operation> = Operation extends { responses: { 200: { content: infer Content } } }
  ? Content[keyof Content]
  : never;

/**
 * The function that sends requests of one method. Its promise rejects with ApiError, which has the
 * server's message, or with ServerUnreachable.
 */
const requests =
  <M extends Method>(method: M) =>
  async <P extends Path<M>>(
    path: P,
    ...init: undefined extends Init<P, M> ? [Init<P, M>?] : [Init<P, M>]
  ): Promise<ResponseBody<paths[P][M]>> =>
    (await http.request(method, path, ...(init as never))).data as ResponseBody<paths[P][M]>;

export const [get, post, put, patch, del] = [
  requests("get"),
  requests("post"),
  requests("put"),
  requests("patch"),
  requests("delete"),
];

/** Fills the `{id}` of a path. */
export const of = (id: string) => ({ params: { path: { id } } });

/** Like `of`, for a response that is a file; `file` gives the response its type. */
export const asFile = (id: string) => ({ ...of(id), parseAs: "blob" }) as const;
export const file = (answer: Promise<string>) => answer as Promise<unknown> as Promise<Blob>;

/** A file together with the headers of its response. */
export const fileAnswer = async (
  path: "/api/programs/{id}/file" | "/api/groups/{id}/file",
  init: ReturnType<typeof asFile>,
) => {
  const { data, response } = await http.GET(path, init);
  return { data: data as Blob, response };
};

/** Maximum length of a keepalive request. The fetch standard limits all in flight to 64 KiB. */
const KEEPALIVE_LIMIT = 60_000;

/** Requests about the app, groups, programs and runs, which the page needs from its start. */
export const api = {
  status: () => get("/api/status"),
  beginEmpty: () => post("/api/database/begin-empty", {}),

  groups: async () => (await get("/api/groups")).groups,

  programs: async (group: string) => (await get("/api/groups/{id}/programs", of(group))).programs,
  createProgram: (group: string, name: string) =>
    post("/api/groups/{id}/programs", { ...of(group), body: { name } }),
  /** `sound`: if the newest version is damaged, gives the newest intact one. */
  program: (id: string, sound = false) =>
    get("/api/programs/{id}", { params: { path: { id }, query: sound ? { sound } : {} } }),
  renameProgram: (id: string, name: string) =>
    patch("/api/programs/{id}", { ...of(id), body: { name } }),
  /** `last`: the page is closing, so the request must outlive it. */
  saveVersion: (program: string, content: EditorContent, last = false) => {
    const body = content as NewVersion;
    const keepalive = last && JSON.stringify(body).length < KEEPALIVE_LIMIT;
    return post("/api/programs/{id}/versions", { ...of(program), body, keepalive });
  },

  runs: (group: string, before: string | null = null, limit = 50) =>
    get("/api/groups/{id}/runs", { params: { path: { id: group }, query: { before, limit } } }),
  startRun: (version_id: string, world: string, debugging: RunOptions) =>
    post("/api/runs", { body: { version_id, world, ...debugging } }),
  command: (run: string, body: LiveCommand) =>
    post("/api/runs/{id}/commands", { ...of(run), body }),
  writePython: (document: object) => post("/api/python", { body: { document } as DocumentToWrite }),
  readPython: (text: string) => post("/api/python/read", { body: { text } }),

  run: (id: string) => get("/api/runs/{id}", of(id)),
  runEvents: async (id: string) => (await get("/api/runs/{id}/events", of(id))).events,
  runTelemetry: async (id: string) =>
    (await file(get("/api/runs/{id}/telemetry", asFile(id)))).arrayBuffer(),

  robots: async () => (await get("/api/robots")).robots,
  worlds: async () => (await get("/api/worlds")).worlds,
  /** All faults of a world, as texts. */
  checkWorld: async (world: unknown) =>
    (await post("/api/worlds/check", { body: { world } })).faults,
};
