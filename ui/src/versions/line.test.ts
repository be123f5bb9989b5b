import { describe, expect, test } from "vitest";
import type { VersionSummary } from "../api/model";

import { type Fork, faceOf, sectionsOf, type VersionStep, versionsIn } from "./line";

const BEGIN = Date.UTC(2026, 9, 5, 15);

/** A version with a number, created `seconds` after the first. */
function version(
  number: number,
  seconds: number,
  more: Partial<VersionSummary> = {},
): VersionSummary {
  return {
    id: `${more.computer ?? ""}${number}`,
    number,
    created_at: new Date(BEGIN + seconds * 1000).toISOString(),
    can_run: true,
    label: "",
    parent_id: number > 1 ? String(number - 1) : null,
    lesson_id: "lesson",
    computer: "PC 1",
    n_runs: 0,
    n_passed: 0,
    setup: null,
    setup_only: false,
    ...more,
  };
}

const numbers = (item: VersionStep | Fork | undefined) =>
  item?.kind === "step" ? item.versions.map((one) => one.number) : [];

describe("the line of versions", () => {
  test("shows a burst of edits as one mark, and ends it at a pause", () => {
    const line = [version(1, 0), version(2, 5), version(3, 9), version(4, 300)];
    const [section] = sectionsOf(line);
    expect(section?.items.map(numbers)).toEqual([[1, 2, 3], [4]]);
    expect(faceOf(section?.items[0] as VersionStep).number).toBe(3);
  });

  test("shows what ran and what has a name by itself", () => {
    const line = [
      version(1, 0),
      version(2, 5, { n_runs: 2 }),
      version(3, 9),
      version(4, 12, { label: "anda" }),
      version(5, 14),
    ];
    expect(sectionsOf(line)[0]?.items.map(numbers)).toEqual([[1], [2], [3], [4], [5]]);
  });

  test("begins anew with each lesson and each day", () => {
    const line = [
      version(1, 0),
      version(2, 5, { lesson_id: "next" }),
      version(3, 9, { lesson_id: "next" }),
      version(4, 86_400, { lesson_id: "next" }),
    ];
    const sections = sectionsOf(line);
    expect(sections.map((one) => versionsIn(one).map(({ number }) => number))).toEqual([
      [1],
      [2, 3],
      [4],
    ]);
    expect(sections[1]?.from).toBe(line[1]?.created_at);
    expect(sections[1]?.to).toBe(line[2]?.created_at);
  });

  test("keeps apart what two PCs made of the same version", () => {
    const line = [
      version(1, 0),
      version(2, 5),
      version(2, 7, { computer: "PC 2" }),
      version(3, 9),
      version(3, 11, { computer: "PC 2" }),
      version(4, 13, { computer: "PC 2" }),
    ];
    const [section] = sectionsOf(line);
    const fork = section?.items[1] as Fork;
    expect(fork.branches.map(({ computer }) => computer)).toEqual(["PC 1", "PC 2"]);
    expect(fork.branches.map(({ steps }) => steps.map(numbers))).toEqual([[[2, 3]], [[2, 3]]]);
    expect(numbers(section?.items[2])).toEqual([4]);
  });

  test("tells PCs without a name apart by what was made of what", () => {
    const line = [
      version(1, 0, { id: "a", computer: null }),
      version(2, 5, { id: "b", parent_id: "a", computer: null }),
      version(2, 7, { id: "c", parent_id: "a", computer: null }),
      version(3, 9, { id: "d", parent_id: "c", computer: null }),
      version(3, 11, { id: "e", parent_id: "b", computer: null }),
    ];
    const fork = sectionsOf(line)[0]?.items[1] as Fork;
    expect(
      fork.branches.map(({ steps }) => steps.flatMap(({ versions }) => versions.map((v) => v.id))),
    ).toEqual([
      ["b", "e"],
      ["c", "d"],
    ]);
  });

  test("of a clock that was set back stays in its order", () => {
    const line = [version(1, 0), version(2, -20), version(3, -10)];
    expect(sectionsOf(line)[0]?.items.map(numbers)).toEqual([[1, 2, 3]]);
  });

  test("is empty where nothing was saved", () => {
    expect(sectionsOf([])).toEqual([]);
  });
});
