import * as Blockly from "blockly/core";
import { afterEach, beforeAll, beforeEach, describe, expect, test } from "vitest";
import { registerBlocks } from "..";
import { generateDocument } from "../generator";
import { setKnownSigns } from "../known_signs";
import { workspaceOf } from "../loader";
import { setBlockLanguage } from "../texts";
import { SignField } from "./sign_field";

beforeAll(registerBlocks);
beforeEach(() => setBlockLanguage("pt-BR"));
afterEach(() => setKnownSigns(null));

function signField(): SignField {
  const field = new Blockly.Workspace().newBlock("text_letter").getField("TEXT");
  if (!(field instanceof SignField)) throw new Error("text_letter lost its sign");
  return field;
}

/** The labels that the menu offers; a line for a separator. */
function offered(field: SignField): string[] {
  Object.assign(field, { listing: true });
  const options = field.getOptions();
  Object.assign(field, { listing: false });
  return options.map((option) => {
    if (option === "separator") return "-";
    const [label] = option;
    return label instanceof HTMLElement ? (label.textContent ?? "") : String(label);
  });
}

describe("the sign on a block", () => {
  test("is a letter, or one that the class taught, or none, or another", () => {
    const field = signField();
    expect(field.getText()).toBe("B");
    expect(offered(field).slice(-3)).toEqual(["-", "nenhum sinal", "Outro sinal…"]);
    expect(offered(field)).toHaveLength(21 + 3);
    setKnownSigns({ named: ["vai", "7"], hasClass: true });
    expect(offered(field).slice(20)).toEqual([
      ...["W", "-", "7", "vai", "-", "nenhum sinal", "Outro sinal…"],
    ]);
  });

  test("stays what the program says where the class does not know it, and is offered too", () => {
    const field = signField();
    field.setValue("pare já");
    expect([field.getValue(), field.getText()]).toEqual(["pare já", "pare já"]);
    expect(offered(field)).toContain("pare já");
    field.setValue("");
    expect([field.getValue(), field.getText()]).toEqual(["", "nenhum sinal"]);
  });

  test.each([
    ...["vai", "7", "H", "", " dois  espaços ", 'aspas " e \n linha', "x".repeat(10_000)],
  ])("is the same in a document and back: %j", (result) => {
    const document = {
      pinel_ir: 1,
      name: "sinais",
      functions: [],
      commands: [{ action: "set_gesture_result", block: "b1", result }],
    };
    const workspace = new Blockly.Workspace();
    Blockly.serialization.workspaces.load(workspaceOf(document), workspace);
    expect(generateDocument(workspace, "sinais")).toEqual(document);
  });
});
