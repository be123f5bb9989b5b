import { expect, test } from "vitest";
import type { Lesson } from "../../api/model";
import { whole, withParts } from "./lessons";

const lesson = (id: string, more: Partial<Lesson> = {}): Lesson => ({
  id,
  classroom_id: "c",
  title: "",
  activity: null,
  by_itself: true,
  computer: "PC 1",
  opened_at: `2026-11-2${id}T12:00:00Z`,
  used_at: "",
  closed_at: null,
  part_of: null,
  n_versions: 0,
  n_runs: 0,
  ...more,
});

test("lessons that were joined stand below the one that they are part of", () => {
  const groups = withParts([lesson("3", { part_of: "1" }), lesson("2"), lesson("1")]);
  expect(groups.map(({ lesson: one, parts }) => [one.id, parts.map(({ id }) => id)])).toEqual([
    ["2", []],
    ["1", ["3"]],
  ]);
});

test("a part of a lesson that is not there is not lost", () => {
  expect(withParts([lesson("3", { part_of: "9" })])).toHaveLength(1);
});

test("the first with a title is what the others become part of", () => {
  const titled = lesson("2", { title: "Quadrados" });
  expect(whole([lesson("1"), titled, lesson("3", { title: "Outra" })])).toBe(titled);
  expect(whole([lesson("3"), lesson("1")])?.id).toBe("1");
  expect(whole([])).toBeUndefined();
});
