import * as Blockly from "blockly/core";
import { afterEach, beforeAll, describe, expect, test } from "vitest";
import { registerBlocks } from "../../blocks";
import { setKnownSigns } from "../../blocks/known_signs";
import { workspaceOf } from "../../blocks/loader";
import { setBlockLanguage } from "../../blocks/texts";
import { unknownIn } from "./unknown_signs";

beforeAll(() => {
  setBlockLanguage("pt-BR");
  registerBlocks();
});
afterEach(() => setKnownSigns(null));

const GESTURE = { gesture: "result" };
const is = (left: unknown, right: unknown) => ({ op: "==", args: [left, right] });
const when = (block: string, condition: object, commands: object[] = []) => ({
  ...{ action: "conditional_execution", block, condition, commands },
});

function unknown(...commands: object[]): Record<string, string[]> {
  const workspace = new Blockly.Workspace();
  const document = { pinel_ir: 1, name: "p", functions: [], commands };
  Blockly.serialization.workspaces.load(workspaceOf(document), workspace);
  return Object.fromEntries([...unknownIn(workspace)].map(([id, names]) => [id, [...names]]));
}

describe("a command is warned of", () => {
  test("where it names a sign that the class does not know", () => {
    setKnownSigns({ named: ["vai"], hasClass: true });
    const program = [
      when("a", is(GESTURE, "pare"), [when("b", is("H", GESTURE))]),
      { action: "set_gesture_result", block: "c", result: "olá" },
    ];
    expect(unknown(...program)).toEqual({ a: ["pare"], b: ["H"], c: ["olá"] });
  });

  test("with all of its unknown signs, each once", () => {
    setKnownSigns({ named: [], hasClass: false });
    const either = { op: "or", args: [is(GESTURE, "vai"), is(GESTURE, "pare")] };
    const again = { op: "and", args: [either, is(GESTURE, "vai")] };
    expect(unknown(when("a", again))).toEqual({ a: ["vai", "pare"] });
  });

  test("not where the sign is known, whatever its capitals, or is none", () => {
    setKnownSigns({ named: ["vai"], hasClass: true });
    expect(
      unknown(
        when("a", is(GESTURE, "VAI")),
        when("b", is(GESTURE, "b")),
        when("c", is(GESTURE, "")),
      ),
    ).toEqual({});
  });

  test("not while it is unknown what the class knows, nor for other texts", () => {
    expect(unknown(when("a", is(GESTURE, "pare")))).toEqual({});
    setKnownSigns({ named: [], hasClass: true });
    expect(
      unknown({ action: "say", block: "a", text: "olá" }, when("b", is({ var: "cor" }, "azul"))),
    ).toEqual({});
  });
});
