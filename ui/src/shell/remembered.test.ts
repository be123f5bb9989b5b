import { afterEach, beforeEach, expect, test, vi } from "vitest";

const sent = vi.fn(async (request: Request) => {
  bodies.push(await request.json());
  return new Response("{}", { headers: { "Content-Type": "application/json" } });
});
let bodies: unknown[] = [];

/** The module as the page loads it, served with these settings. */
async function served(kept?: Record<string, string>) {
  vi.resetModules();
  if (kept) document.documentElement.dataset.kept = JSON.stringify(kept);
  else delete document.documentElement.dataset.kept;
  return import("./remembered");
}

beforeEach(() => {
  bodies = [];
  sent.mockClear();
  vi.stubGlobal("fetch", sent);
});
afterEach(() => vi.unstubAllGlobals());

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
  await vi.waitFor(() => expect(bodies).toEqual([{ name: "pinel_theme", value: "dark" }]));
});

test("a cookie of an earlier release is read once and goes to the server", async () => {
  // biome-ignore lint/suspicious/noDocumentCookie: as earlier releases did
  document.cookie = "pinel_muted=1; path=/";
  const { remembered } = await served();
  expect(remembered("pinel_muted")).toBe("1");
  expect(document.cookie).not.toContain("pinel_muted");
  expect(remembered("pinel_muted")).toBe("1");
  await vi.waitFor(() => expect(bodies).toEqual([{ name: "pinel_muted", value: "1" }]));
});

test("where the server keeps nothing, it holds until the page is left", async () => {
  sent.mockImplementationOnce(async () => new Response("{}", { status: 503 }));
  const { remember, remembered } = await served();
  remember("pinel_turns", "5");
  expect(remembered("pinel_turns")).toBe("5");
});
