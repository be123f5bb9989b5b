import { expect, test } from "vitest";
import { levelNeeded } from "./level_needed";

const program = (block: object) => ({
  blocks: { blocks: [{ type: "program_start", next: { block } }] },
});

test.each([
  [null, 1],
  [program({ type: "move_forward", inputs: { DISTANCE: { shadow: { type: "number" } } } }), 1],
  [program({ type: "repeat", inputs: { DO: { block: { type: "until" } } } }), 2],
  [program({ type: "say", inputs: { TEXT: { block: { type: "lidar" } } } }), 3],
])("%j needs level %d", (workspace, level) => {
  expect(levelNeeded(workspace)).toBe(level);
});
