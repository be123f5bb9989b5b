import type * as Blockly from "blockly/core";
import type { StatementBlockType } from "../blocks/definitions";
import type { Command } from "./document";
import { generateInput } from "./values";

/** Makes one block's command; `body` makes the commands inside one of its mouths. */
type CommandGenerator = (block: Blockly.Block, body: (input: string) => Command[]) => Command;

/** One generator per block that stands in a stack. A block without one does not compile. */
export const COMMANDS: Readonly<Record<StatementBlockType, CommandGenerator>> = {
  move_forward: (block) => ({ action: "move_forward", distance: numberOf(block, "DISTANCE") }),
  move_backward: (block) => ({ action: "move_backward", distance: numberOf(block, "DISTANCE") }),
  turn: (block) => ({ action: "turn", angle: signedAngle(block) }),
  wait: (block) => ({ action: "wait", seconds: numberOf(block, "SECONDS") }),
  stop: () => ({ action: "stop" }),
  repeat: (block, body) => ({
    action: "repeat",
    times: numberOf(block, "TIMES"),
    commands: body("DO"),
  }),
  if: (block, body) => ({
    action: "conditional_execution",
    ...condition(block),
    commands: body("THEN"),
  }),
  if_else: (block, body) => ({
    action: "conditional_execution",
    ...condition(block),
    commands: body("THEN"),
    else: body("ELSE"),
  }),
  classify_gestures: (block) => ({
    action: "classify_gestures",
    timeout: numberOf(block, "TIMEOUT"),
  }),
  set_gesture_result: (block) => ({
    action: "set_gesture_result",
    result: String(block.getFieldValue("RESULT")),
  }),
};

function numberOf(block: Blockly.Block, field: string): number {
  return Number(block.getFieldValue(field));
}

function signedAngle(block: Blockly.Block): number {
  const angle = numberOf(block, "ANGLE");
  // a right turn by 0 would be -0, which JSON cannot tell and a comparison can
  return block.getFieldValue("DIRECTION") === "RIGHT" && angle !== 0 ? -angle : angle;
}

/** An empty hole leaves the key out, so that the reader names the fault at this block. */
function condition(block: Blockly.Block): object {
  const expression = generateInput(block, "CONDITION");
  return expression === null ? {} : { condition: expression };
}
