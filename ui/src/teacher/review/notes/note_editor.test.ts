import { signal } from "@preact/signals";
import { beforeAll, expect, test } from "vitest";
import { setLanguage } from "../../../i18n";
import { type NoteEditor, stateText } from "./note_editor";

beforeAll(() => setLanguage("pt-BR"));

const editorOf = (otherComputer: string | null) =>
  ({
    note: signal(null),
    text: signal(""),
    state: signal("unchanged"),
    changed: false,
    otherComputer,
  }) as unknown as NoteEditor;

test("a note about a run of another PC promises no more than a merge there", () => {
  expect(stateText(editorOf(null))).toContain("próxima vez que entrar");
  const there = stateText(editorOf("PC 07"));
  expect(there).toContain("“PC 07”");
  expect(there).not.toContain("próxima vez");
});
