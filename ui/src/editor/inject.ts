import * as Blockly from "blockly/core";
import { toolbox } from "../blocks/toolbox";
import type { EditorOptions } from ".";
import { RENDERER, registerRenderer } from "./renderer";
import { blocklyTheme } from "./themes";
import { registerToolboxCategory } from "./toolbox_category";

export function injectWorkspace(options: EditorOptions): Blockly.WorkspaceSvg {
  registerRenderer();
  registerToolboxCategory();
  // a finger, or a shared mouse, lets go well beside the gap it means
  Blockly.config.snapRadius = 40;
  Blockly.config.connectingSnapRadius = 40;
  // what was deleted comes back with undo or from the trash, so nobody is asked
  Blockly.dialog.setConfirm((_message, answer) => answer(true));
  keepMenusShort();
  return Blockly.inject(options.container, {
    toolbox: toolbox(),
    theme: blocklyTheme(options.theme),
    renderer: RENDERER,
    media: options.mediaPath,
    sounds: false,
    trashcan: true,
    maxTrashcanContents: 16,
    maxInstances: { program_start: 1 },
    collapse: false,
    comments: false,
    disable: false,
    modalInputs: false,
    move: { scrollbars: true, drag: true, wheel: true },
    zoom: { controls: false, wheel: false, pinch: true, startScale: 1, maxScale: 2, minScale: 0.4 },
  });
}

/** Of Blockly's menu entries, those that mean nothing here. */
const IDLE_ENTRIES = ["blockInline", "blockHelp"];

function keepMenusShort(): void {
  const { registry } = Blockly.ContextMenuRegistry;
  for (const entry of IDLE_ENTRIES) if (registry.getItem(entry)) registry.unregister(entry);
}
