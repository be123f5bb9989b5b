import { expect, test } from "vitest";
import type { GroupReview } from "../../../api/model";
import { computersOfLookalike } from "./lookalikes";

const groupOf = (id: string, color: string, ...computers: string[]) =>
  ({
    group: { id, name: id, color, picture: "rocket" },
    entries: computers.map((computer) => ({ computer })),
  }) as unknown as GroupReview;

test("a group with the picture and the colour of another is told apart by its PCs", () => {
  const alike = [groupOf("a", "#111111", "PC 1", "PC 1"), groupOf("b", "#111111", "PC 2", "PC 3")];
  const ofOnePc = [groupOf("c", "#222222", "PC 4"), groupOf("d", "#222222", "PC 4")];
  const all = [...alike, ...ofOnePc, groupOf("e", "#333333", "PC 5")];
  expect(all.map((one) => computersOfLookalike(one, all))).toEqual([
    "PC 1",
    "PC 2, PC 3",
    "",
    "",
    "",
  ]);
});
