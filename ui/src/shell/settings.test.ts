import { waitFor } from "@testing-library/preact";
import { afterEach, beforeEach, expect, test, vi } from "vitest";

const sent = vi.fn<(request: Request) => Promise<Response>>();
let bodies: unknown[] = [];

async function answer(request: Request) {
  bodies.push(await request.json());
  return new Response("{}", { headers: { "Content-Type": "application/json" } });
}

/** Loads the module as the page does, with these settings from the server. */
async function served(settings?: Record<string, string>) {
  vi.resetModules();
  if (settings) document.documentElement.dataset.settings = JSON.stringify(settings);
  else delete document.documentElement.dataset.settings;
  return import("./settings");
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

test("the page is served with what was chosen, and asks for nothing", async () => {
  const { setting } = await served({ pinel_theme: "dark" });
  expect(setting("pinel_theme").value).toBe("dark");
  expect(setting("pinel_class").value).toBe("");
  expect(sent).not.toHaveBeenCalled();
});

test("what is chosen is there at once and goes to the server, once", async () => {
  const { choose, setting } = await served();
  const chosen = choose("pinel_theme", "dark");
  expect(setting("pinel_theme").value).toBe("dark");
  await chosen;
  await choose("pinel_theme", "dark");
  expect(bodies).toEqual([{ name: "pinel_theme", value: "dark" }]);
});

test("of two choices in a row the server gets the second once it has answered the first", async () => {
  const { choose } = await served();
  let answerFirst = () => {};
  sent.mockImplementationOnce(async (request) => {
    await new Promise<void>((resolve) => {
      answerFirst = resolve;
    });
    return answer(request);
  });
  const both = [choose("pinel_language", "en"), choose("pinel_language", "es")];
  await waitFor(() => expect(sent).toHaveBeenCalledTimes(1));
  answerFirst();
  await Promise.all(both);
  expect(bodies).toEqual(["en", "es"].map((value) => ({ name: "pinel_language", value })));
});

test("where the server keeps nothing, it holds until the window is closed", async () => {
  sent.mockImplementation(async () => new Response("{}", { status: 503 }));
  const { choose, setting } = await served();
  await choose("pinel_turns", "5");
  expect(setting("pinel_turns").value).toBe("5");
  expect((await served()).setting("pinel_turns").value).toBe("5");
});

test("a choice whose request did not get through before the page was left is sent again", async () => {
  sent.mockImplementationOnce(() => Promise.reject(new TypeError("Failed to fetch")));
  await (await served({ pinel_class: "a" })).choose("pinel_class", "b");
  const { setting } = await served({ pinel_class: "a" });
  expect(setting("pinel_class").value).toBe("b");
  await waitFor(() => expect(bodies).toEqual([{ name: "pinel_class", value: "b" }]));
  await waitFor(() => expect(sessionStorage).toHaveLength(0));
});

test("a choice that is answered while the page is being left is sent again", async () => {
  const { choose } = await served({ pinel_class: "a" });
  const chosen = choose("pinel_class", "b");
  dispatchEvent(new Event("beforeunload"));
  await chosen;
  const { setting } = await served({ pinel_class: "a" });
  expect(setting("pinel_class").value).toBe("b");
  await waitFor(() => expect(bodies).toHaveLength(2));
  await waitFor(() => expect(sessionStorage).toHaveLength(0));
});
