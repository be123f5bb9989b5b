import * as Blockly from "blockly/core";
import { registerBlocks } from "../blocks";
import { generateDocument } from "../blocks/generator";
import { workspaceOf } from "../blocks/loader";
import { language } from "../i18n";
import { applyLanguage } from "./locale";
import { withoutEvents } from "./without_events";

/** The content that an editor would save for a document, computed without an editor. */
export function contentOf(document: { name?: string }): { workspace: object; document: object } {
  applyLanguage(language.peek());
  registerBlocks();
  const trial = new Blockly.Workspace();
  try {
    withoutEvents(() => Blockly.serialization.workspaces.load(workspaceOf(document), trial));
    trial.getBlocksByType("program_start")[0]?.setDeletable(false);
    return {
      workspace: Blockly.serialization.workspaces.save(trial),
      document: generateDocument(trial, document.name ?? ""),
    };
  } finally {
    trial.dispose();
  }
}
