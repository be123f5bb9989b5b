import { afterEach, expect, test, vi } from "vitest";
import { api } from "./client";
import { ApiError, ServerUnreachable } from "./errors";
import { exchange } from "./exchange";
import { reviewApi } from "./review";

/** Answers each request with `answer`; returns the list that collects the requests. */
function serverThat(answer: (request: Request) => Response | Promise<Response>): Request[] {
  const sent: Request[] = [];
  vi.stubGlobal("fetch", (request: Request) => {
    sent.push(request.clone());
    return answer(request);
  });
  return sent;
}

const refusal = {
  code: "group_exists",
  message: "Há um grupo.",
  remedy: "Outro nome.",
  params: {},
};

afterEach(() => vi.unstubAllGlobals());

test("a value comes without its response, from an address with its ids", async () => {
  const sent = serverThat(() => Response.json({ programs: [{ id: "p" }] }));
  expect(await api.programs("a/b")).toEqual([{ id: "p" }]);
  expect(sent[0]?.url).toBe(`${location.origin}/api/groups/a%2Fb/programs`);
});

test("a body is JSON, and what is not told of a query is left out", async () => {
  const sent = serverThat(() => Response.json({ runs: [], next: null }));
  await api.createProgram("g", "Casa");
  await api.runs("g");
  await reviewApi.runs(
    {
      classroom: "none",
      group: "",
      lesson: "",
      activity: "",
      world: "",
      day: "",
      outcome: "",
    },
    null,
    5,
  );
  expect(sent[0]?.headers.get("Content-Type")).toBe("application/json");
  expect(await sent[0]?.json()).toEqual({ name: "Casa" });
  expect(sent[1]?.url.split("?")[1]).toBe("limit=50");
  expect(sent[2]?.url.split("?")[1]).toBe("classroom=none&limit=5");
});

test("an error has the server's words", async () => {
  serverThat(() => Response.json({ error: { ...refusal, faults: [] } }, { status: 409 }));
  const error = await api.createProgram("g", "").catch((error) => error);
  expect(error).toBeInstanceOf(ApiError);
  expect(error).toMatchObject({ status: 409, code: "group_exists", message: "Há um grupo." });
});

test("an answer of no shape is an error all the same", async () => {
  serverThat(() => new Response("<html>", { status: 502 }));
  await expect(api.status()).rejects.toMatchObject({ status: 502, code: "http_502" });
});

test("no answer means that the server has gone", async () => {
  serverThat(() => Promise.reject(new TypeError("refused")));
  await expect(api.status()).rejects.toBeInstanceOf(ServerUnreachable);
});

test("a request that was given up is no sign of a server that has gone", async () => {
  serverThat(() => Promise.reject(new DOMException("left", "AbortError")));
  await expect(api.status()).rejects.toMatchObject({ name: "AbortError" });
});

test("the last version outlives the page, unless it is larger than browsers let it", async () => {
  const sent = serverThat(() => Response.json({}));
  await api.saveVersion("p", { workspace: {}, document: null });
  await api.saveVersion("p", { workspace: {}, document: null }, true);
  await api.saveVersion("p", { workspace: { text: "x".repeat(70_000) }, document: null }, true);
  expect(sent.map((request) => request.keepalive)).toEqual([false, true, false]);
});

test("files come as they are", async () => {
  const octets = new Uint8Array([0, 255, 10]);
  serverThat(() => new Response(octets));
  expect(new Uint8Array(await api.runTelemetry("r"))).toEqual(octets);
  expect(await exchange.programFile("p")).toMatchObject({ octets: { size: 3 }, leftOut: null });
});

test("a program's file says what it lacks", async () => {
  const lacks = { code: "c", message: "Nem tudo está lá.", remedy: "" };
  const headers = { "Pinel-Left-Out": JSON.stringify(lacks).replace("á", "\\u00e1") };
  serverThat(() => new Response("abc", { headers }));
  expect((await exchange.programFile("p")).leftOut).toEqual({
    ...lacks,
    message: "Nem tudo está lá.",
  });
});

test("a program's file is sent under its name", async () => {
  const sent = serverThat(() => Response.json({ program_id: "p" }));
  await exchange.bringProgram(new File(["abc"], "Minha casa.pinel"));
  expect(sent[0]?.url).toContain("?name=Minha%20casa.pinel");
  expect(sent[0]?.headers.get("Content-Type")).toBe("application/octet-stream");
});
