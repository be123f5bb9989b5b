import { waitFor } from "@testing-library/preact";
import { afterEach, beforeEach, expect, test, vi } from "vitest";

const sent = vi.fn<(request: Request) => Promise<Response>>();
let bodies: unknown[] = [];

async function answer(request: Request) {
  bodies.push(await request.json());
  return new Response("{}", { headers: { "Content-Type": "application/json" } });
}

/** The module as the page loads it, served with these settings. */
async function served(kept?: Record<string, string>) {
  vi.resetModules();
  if (kept) document.documentElement.dataset.kept = JSON.stringify(kept);
  else delete document.documentElement.dataset.kept;
  return import("./remembered");
}

beforeEach(() => {
  bodies = [];
  sent.mockReset().mockImplementation(answer);
  vi.stubGlobal("fetch", sent);
});
afterEach(() => {
  vi.unstubAllGlobals();
  sessionStorage.clear();
});

test("the page is served with what was kept, and asks for nothing", async () => {
  const { remembered } = await served({ pinel_theme: "dark" });
  expect(remembered("pinel_theme")).toBe("dark");
  expect(remembered("pinel_class")).toBeNull();
  expect(sent).not.toHaveBeenCalled();
});

test("what is remembered goes to the server, once", async () => {
  const { remember, remembered } = await served();
  remember("pinel_theme", "dark");
  remember("pinel_theme", "dark");
  expect(remembered("pinel_theme")).toBe("dark");
  await waitFor(() => expect(bodies).toEqual([{ name: "pinel_theme", value: "dark" }]));
});

test("where the server keeps nothing, it holds until the window is closed", async () => {
  sent.mockImplementation(async () => new Response("{}", { status: 503 }));
  const { remember, remembered } = await served();
  remember("pinel_turns", "5");
  expect(remembered("pinel_turns")).toBe("5");
  expect((await served()).remembered("pinel_turns")).toBe("5");
});

test("a choice whose request did not get through before the page was left is sent again", async () => {
  sent.mockImplementationOnce(() => Promise.reject(new TypeError("Failed to fetch")));
  (await served({ pinel_class: "a" })).remember("pinel_class", "b");
  const { remembered } = await served({ pinel_class: "a" });
  expect(remembered("pinel_class")).toBe("b");
  await waitFor(() => expect(bodies).toEqual([{ name: "pinel_class", value: "b" }]));
  await waitFor(() => expect(sessionStorage).toHaveLength(0));
});
