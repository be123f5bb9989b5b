import { expect, test } from "vitest";
import type { Classroom } from "../api/model";
import { withDistinctNames } from "./namesakes";

const classroom = (name: string, computer: string | null = null) =>
  ({ id: name, name, computer, created_at: "2026-11-21T12:00:00Z" }) as Classroom;
const names = (...classes: Classroom[]) =>
  withDistinctNames(classes, "pt-BR").map(({ name }) => name);

test("a class whose name nobody else has keeps it as it is", () => {
  expect(names(classroom("7º A", "PC 1"), classroom("7º B", "PC 1"))).toEqual(["7º A", "7º B"]);
});

test("classes of one name tell their PC, or the day where there was no lesson yet", () => {
  expect(names(classroom("7º B", "PC 7"), classroom("7ºb"), classroom("8º A"))).toEqual([
    "7º B · PC 7",
    "7ºb · 21 de nov.",
    "8º A",
  ]);
});

test("PCs of one name do not make them one", () => {
  expect(names(classroom("7º B", "PC"), classroom("7º B", "PC"))).toEqual([
    "7º B · PC (1)",
    "7º B · PC (2)",
  ]);
});
