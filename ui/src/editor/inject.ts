import * as Blockly from "blockly/core";
import { toolbox } from "../blocks/toolbox";
import type { EditorOptions } from ".";
import { RENDERER, registerRenderer } from "./renderer";
import { blocklyTheme } from "./themes";
import { registerToolboxCategory } from "./toolbox_category";

export function injectWorkspace(options: EditorOptions): Blockly.WorkspaceSvg {
  registerRenderer();
  registerToolboxCategory();
  // what was deleted comes back with undo or from the trash, so nobody is asked
  Blockly.dialog.setConfirm((_message, answer) => answer(true));
  return Blockly.inject(options.container, {
    toolbox: toolbox(),
    theme: blocklyTheme(options.theme),
    renderer: RENDERER,
    // a row with a word only, as "else", is else so low that the notch above cuts into the word
    rendererOverrides: { DUMMY_INPUT_MIN_HEIGHT: 44 },
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
