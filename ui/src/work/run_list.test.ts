import { afterEach, expect, test, vi } from "vitest";
import { api } from "../api/client";
import type { Run } from "../api/model";
import { RunList } from "./run_list";

/** Pages of two runs each. */
function pages(states: Run["state"][]) {
  const runs = states.map(
    (state, index) => ({ id: String(index), state, program_id: index % 2 ? "b" : "a" }) as Run,
  );
  return vi.spyOn(api, "runs").mockImplementation(async (_, before) => {
    const from = before === null ? 0 : Number(before) + 1;
    const page = runs.slice(from, from + 2);
    return { runs: page, next: from + 2 < runs.length ? (page.at(-1)?.id ?? null) : null };
  });
}

afterEach(() => vi.restoreAllMocks());

const ids = (list: RunList) => list.shown.value.map(({ id }) => id);

test("runs are chosen by outcome and program", async () => {
  pages(["finished", "failed", "finished", "failed"]);
  const list = new RunList("group");
  await list.load();
  await list.older();
  await list.choose("failed", null);
  expect(ids(list)).toEqual(["1", "3"]);
  await list.choose("finished", "b");
  expect(ids(list)).toEqual([]);
  await list.choose(null, null);
  expect(ids(list)).toHaveLength(4);
});

test("a kind of run that is not here yet is looked for further back", async () => {
  const asked = pages(["finished", "finished", "finished", "finished", "stopped", "finished"]);
  const list = new RunList("group");
  await list.load();
  expect(asked).toHaveBeenCalledTimes(1);
  await list.choose("stopped", null);
  expect(ids(list)).toEqual(["4"]);
  expect(asked).toHaveBeenCalledTimes(3);
  expect(list.next.value).toBeNull();
});
