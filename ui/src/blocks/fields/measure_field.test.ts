import * as Blockly from "blockly/core";
import { beforeAll, beforeEach, describe, expect, test } from "vitest";
import { registerBlocks } from "..";
import { setBlockLanguage } from "../texts";

beforeAll(registerBlocks);
beforeEach(() => setBlockLanguage("pt-BR"));

function distanceField(): Blockly.Field {
  const block = new Blockly.Workspace().newBlock("move_forward");
  block.getInput("DISTANCE")?.connection?.setShadowState({ type: "number" });
  const field = block.getInputTargetBlock("DISTANCE")?.getField("NUM");
  if (!field) throw new Error("move_forward lost its distance");
  return field;
}

describe("a measure", () => {
  test.each([
    ["0,5", 0.5],
    ["0.5", 0.5],
    [" 12 ", 12],
    ["0,256", 0.26],
    ["-3", 0],
    ["500", 100],
  ])("takes %j as %d", (typed, value) => {
    const field = distanceField();
    field.setValue(typed);
    expect(field.getValue()).toBe(value);
  });

  test.each(["abc", "1.000,5", "1,2,3"])("refuses %j and keeps what was there", (typed) => {
    const field = distanceField();
    field.setValue("2");
    field.setValue(typed);
    expect(field.getValue()).toBe(2);
  });

  test("is written with a comma in Portuguese and a point in English", () => {
    const field = distanceField();
    field.setValue(0.5);
    expect(field.getText()).toBe("0,5");
    setBlockLanguage("en");
    expect(field.getText()).toBe("0.5");
  });
});
