import { waitFor } from "@testing-library/preact";
import { beforeEach, describe, expect, test, vi } from "vitest";
import type { Sign } from "../api/model";

const signsApi = { use: vi.fn(), list: vi.fn() };
vi.mock("../api/signs", () => ({ signsApi }));

const named = (...names: string[]): Sign[] =>
  names.map((name) => ({ name, is_letter: false, n_samples: 10, n_movements: 0, landmarks: null }));

let page: typeof import("./signs");

beforeEach(async () => {
  vi.resetModules();
  signsApi.use.mockReset().mockImplementation(async (id) => named("A", `of ${id}`));
  signsApi.list.mockReset().mockResolvedValue(named("A", "new"));
  page = await import("./signs");
});

describe("the signs that can be answered", () => {
  test("are the letters until the server has said", async () => {
    expect(page.signs.value).toBeNull();
    expect(page.signNames.value).toEqual(page.LETTERS);
    await page.chooseSigns("c");
    expect(page.signNames.value).toEqual(["A", "of c"]);
  });

  test("are those of the class that was chosen last, whatever the order of the answers", async () => {
    let first: (signs: Sign[]) => void = () => {};
    signsApi.use.mockReturnValueOnce(new Promise((resolve) => (first = resolve)));
    const one = page.chooseSigns("one");
    await waitFor(() => expect(signsApi.use).toHaveBeenCalledWith("one"));
    const two = page.chooseSigns(null);
    await Promise.resolve();
    expect(signsApi.use).toHaveBeenCalledTimes(1);
    first(named("late"));
    await Promise.all([one, two]);
    expect(page.signNames.value).toEqual(["A", "of null"]);
    expect(signsApi.use.mock.lastCall).toEqual([null]);
  });

  test("are never for a moment those of the class before", async () => {
    await page.chooseSigns("one");
    void page.chooseSigns("two");
    expect(page.signs.value).toBeNull();
    expect(page.classOfSigns.value).toBe("two");
  });

  test("are listed anew when what the class taught has changed, in any window", async () => {
    await page.askForSigns("c");
    await page.chooseSigns("c");
    await page.askForSigns("other");
    expect(signsApi.list).not.toHaveBeenCalled();
    await page.askForSigns("c");
    await page.askForSigns(null);
    expect(signsApi.list.mock.calls).toEqual([["c"], ["c"]]);
    expect(page.signNames.value).toEqual(["A", "new"]);
  });

  test("are the letters again when the class was deleted", async () => {
    const { ApiError } = await import("../api/errors");
    await page.chooseSigns("c");
    signsApi.list.mockRejectedValue(new ApiError(404, { code: "classroom_not_found" }));
    await page.askForSigns(null);
    await waitFor(() => expect(page.signNames.value).toEqual(["A", "of null"]));
    expect(page.classOfSigns.value).toBeNull();
  });

  test("stay when the server is gone, and are chosen again when it is back", async () => {
    await page.chooseSignsAgain();
    expect(signsApi.use).not.toHaveBeenCalled();
    await page.chooseSigns("c");
    signsApi.use.mockRejectedValueOnce(new Error("gone"));
    await page.chooseSignsAgain();
    expect(page.signNames.value).toEqual(["A", "of c"]);
    await page.chooseSignsAgain();
    expect(signsApi.use).toHaveBeenCalledTimes(3);
  });

  test("are found whatever the capitals, and a key is one of a single character", async () => {
    signsApi.use.mockResolvedValue(named("A", "Vai", "7"));
    await page.chooseSigns("c");
    expect(["vai", "a", "olá"].map(page.canonicalSign)).toEqual(["Vai", "A", "olá"]);
    const onSign = vi.fn();
    const stop = page.listenForSigns(onSign);
    for (const key of ["a", "7", "b", "v"]) {
      document.body.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
    }
    stop();
    expect(onSign.mock.calls).toEqual([["A"], ["7"]]);
  });
});
