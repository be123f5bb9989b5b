import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { ApiError } from "../../api/errors";
import type { EditorContent, SavedState } from "../../api/model";
import { Autosave, mayPass } from "./autosave";

const content = (n: number): EditorContent => ({ workspace: { n }, document: null });
const version = (n: number): SavedState => ({ id: `v${n}`, faults: [] });

/** A fake server that can be made to fail and records the content that it receives. */
function server() {
  const sent: { content: EditorContent; last: boolean }[] = [];
  const state = { failing: false, slow: 0 };
  const save = async (what: EditorContent, last: boolean) => {
    sent.push({ content: what, last });
    if (state.slow > 0) await new Promise((resolve) => setTimeout(resolve, state.slow));
    if (state.failing) throw new Error("no disk");
    return version(sent.length);
  };
  return { sent, state, save };
}

beforeEach(() => {
  vi.useFakeTimers();
});

afterEach(() => {
  vi.useRealTimers();
});

describe("an edit", () => {
  test("is saved when the hand rests", async () => {
    const { sent, save } = server();
    const autosave = new Autosave(save);
    autosave.edit(content(1));
    expect(autosave.state.value).toBe("saving");
    await vi.advanceTimersByTimeAsync(300);
    expect(sent).toHaveLength(1);
    expect(autosave.state.value).toBe("saved");
    expect(autosave.version.value?.id).toBe("v1");
  });

  test("is on its way within a second even when editing goes on", async () => {
    const { sent, save } = server();
    const autosave = new Autosave(save);
    for (let at = 0; at < 1000; at += 100) {
      autosave.edit(content(at));
      await vi.advanceTimersByTimeAsync(100);
    }
    expect(sent.length).toBeGreaterThanOrEqual(1);
  });

  test("of many, only the newest is saved", async () => {
    const { sent, save } = server();
    const autosave = new Autosave(save);
    autosave.edit(content(1));
    autosave.edit(content(2));
    await vi.advanceTimersByTimeAsync(300);
    expect(sent.map((one) => one.content)).toEqual([content(2)]);
  });

  test("made while another is being saved is saved after it", async () => {
    const { sent, state, save } = server();
    state.slow = 1000;
    const autosave = new Autosave(save);
    autosave.edit(content(1));
    await vi.advanceTimersByTimeAsync(400);
    autosave.edit(content(2));
    await vi.advanceTimersByTimeAsync(3000);
    expect(sent.map((one) => one.content)).toEqual([content(1), content(2)]);
    expect(autosave.state.value).toBe("saved");
  });
});

describe("a failure", () => {
  test("is shown and tried again until it succeeds", async () => {
    const { sent, state, save } = server();
    state.failing = true;
    const autosave = new Autosave(save);
    autosave.edit(content(1));
    await vi.advanceTimersByTimeAsync(300);
    expect(autosave.state.value).toBe("failed");
    expect(autosave.problem.value).toBeInstanceOf(Error);
    state.failing = false;
    await vi.advanceTimersByTimeAsync(1000);
    expect(autosave.state.value).toBe("saved");
    expect(autosave.problem.value).toBeNull();
    expect(sent.at(-1)?.content).toEqual(content(1));
  });

  test("never saves an older edit over a newer one", async () => {
    const { sent, state, save } = server();
    state.failing = true;
    state.slow = 200;
    const autosave = new Autosave(save);
    autosave.edit(content(1));
    await vi.advanceTimersByTimeAsync(400);
    autosave.edit(content(2));
    state.failing = false;
    await vi.advanceTimersByTimeAsync(5000);
    expect(sent.at(-1)?.content).toEqual(content(2));
    expect(autosave.state.value).toBe("saved");
  });

  test("is told to whoever waits", async () => {
    const { state, save } = server();
    state.failing = true;
    const autosave = new Autosave(save);
    autosave.edit(content(1));
    await expect(autosave.flush()).rejects.toThrow("no disk");
  });
});

describe("a program that was deleted", () => {
  test("is not tried again, whatever is edited or asked for", async () => {
    const notFound = new ApiError(404, { code: "program_not_found", message: "Gone." });
    let tried = 0;
    const autosave = new Autosave(async () => {
      tried += 1;
      throw notFound;
    });
    autosave.edit(content(1));
    await vi.advanceTimersByTimeAsync(20_000);
    expect(autosave.state.value).toBe("deleted");
    autosave.edit(content(2));
    await expect(autosave.flush()).rejects.toBe(notFound);
    autosave.flushLast();
    await vi.advanceTimersByTimeAsync(20_000);
    expect(tried).toBe(1);
    expect(autosave.state.value).toBe("deleted");
  });
});

describe("flush", () => {
  test("saves at once and gives the version", async () => {
    const { save } = server();
    const autosave = new Autosave(save);
    autosave.edit(content(1));
    expect((await autosave.flush())?.id).toBe("v1");
  });

  test("with nothing to save gives the version that is there", async () => {
    const { sent, save } = server();
    const autosave = new Autosave(save, version(7));
    expect((await autosave.flush())?.id).toBe("v7");
    expect(sent).toEqual([]);
  });

  test("at the page's end sends what is left, marked as the last", () => {
    const { sent, save } = server();
    const autosave = new Autosave(save);
    autosave.edit(content(1));
    autosave.flushLast();
    expect(sent).toEqual([{ content: content(1), last: true }]);
  });

  test("at the page's end sends nothing when all is saved", () => {
    const { sent, save } = server();
    new Autosave(save).flushLast();
    expect(sent).toEqual([]);
  });
});

test("a program that left the screen is saved as soon as that is possible", async () => {
  const { sent, state, save } = server();
  const autosave = new Autosave(save);
  autosave.edit(content(1));
  state.failing = true;
  await vi.advanceTimersByTimeAsync(300);
  autosave.dispose();
  await vi.advanceTimersByTimeAsync(10_000);
  expect(autosave.state.value).toBe("failed");
  state.failing = false;
  await vi.advanceTimersByTimeAsync(5000);
  expect(autosave.state.value).toBe("saved");
  expect(sent.at(-1)?.content).toEqual(content(1));
});

test("what a later try cannot save is not tried again by itself", async () => {
  let n = 0;
  const refused = new ApiError(413, {
    code: "body_too_large",
    message: "",
    remedy: "",
    params: {},
  });
  const autosave = new Autosave(async () => {
    n += 1;
    throw refused;
  });
  autosave.edit(content(1));
  await vi.advanceTimersByTimeAsync(60_000);
  expect([n, autosave.state.value]).toEqual([1, "failed"]);
  autosave.edit(content(2));
  await vi.advanceTimersByTimeAsync(300);
  expect(n).toBe(2);
});

test.each([
  ["disk_full", true],
  ["database_locked", true],
  ["disk_full_at_start", false],
  ["body_too_large", false],
])("after %s, time alone helps: %j", (code, helps) => {
  expect(mayPass(new ApiError(500, { code, message: "", remedy: "", params: {} }))).toBe(helps);
  expect(mayPass(new Error("no network"))).toBe(true);
});
