import { renderHook, waitFor } from "@testing-library/preact";
import { expect, test, vi } from "vitest";
import type { Merged } from "../../api/model";

const merge = vi.fn<(path: string, retained?: readonly string[]) => Promise<Merged>>();
vi.mock("../../api/exchange", () => ({ exchange: { merge } }));

const { useMerging } = await import("./useMerging");

const result = (path: string, more: Partial<Merged> = {}) =>
  ({ path, problem: null, nothing_new: true, ...more }) as Merged;

test("a deletion waits for the files that are being merged, and those without news are merged again", async () => {
  let arrive: (merged: Merged) => void = () => {};
  merge.mockResolvedValueOnce(result("newer", { nothing_new: false }));
  merge.mockReturnValueOnce(
    new Promise((resolve) => {
      arrive = resolve;
    }),
  );
  merge.mockImplementation(async (path) => result(path, { nothing_new: false }));
  const merging = renderHook(() => useMerging(async () => {})).result.current;

  const merged = merging.mergeAll(["newer", "older"]);
  await waitFor(() => expect(merge).toHaveBeenCalledTimes(2));
  const deleted = merging.deleteToo("newer", []);
  await new Promise((resolve) => setTimeout(resolve, 20));
  expect(merge).toHaveBeenCalledTimes(2);

  arrive(result("older"));
  await Promise.all([merged, deleted]);
  expect(merge.mock.calls.slice(2)).toEqual([
    ["newer", []],
    ["older", undefined],
  ]);
  expect(merging.results.value.map(({ nothing_new }) => nothing_new)).toEqual([false, false]);
});
