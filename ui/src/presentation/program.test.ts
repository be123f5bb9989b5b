import { expect, test } from "vitest";
import { blocksOf } from "./program";

test("blocks follow each other as in the program, those inside a block after it", () => {
  const document = {
    pinel_ir: 1,
    functions: [],
    commands: [
      {
        action: "repeat",
        block: "a",
        times: { sensor: "distance", block: "value" },
        commands: [{ action: "turn", block: "b", angle: 90 }],
      },
      { action: "wait", block: "c", seconds: 1 },
    ],
  };
  expect(blocksOf(document)).toEqual(["a", "b", "c"]);
});

test("a program whose blocks have faults has no document, and no blocks to point at", () => {
  expect(blocksOf(null)).toEqual([]);
});
