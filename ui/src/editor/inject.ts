import * as Blockly from "blockly/core";
import { keepCallsInStep } from "../blocks/function_sync";
import { registerFlyouts, toolbox } from "../blocks/toolbox";
import type { EditorOptions } from ".";
import { adaptMenus } from "./menus";
import { askOnlyDrawnFields } from "./quietly";
import { RENDERER, registerRenderer } from "./renderer";
import { registerSearchItem } from "./search_item";
import { blocklyTheme } from "./themes";
import { registerToolboxCategory } from "./toolbox_category";

export function injectWorkspace(options: EditorOptions): Blockly.WorkspaceSvg {
  registerRenderer();
  registerToolboxCategory();
  registerSearchItem();
  // a finger, or a shared mouse, lets go well beside the gap it means
  Blockly.config.snapRadius = 40;
  Blockly.config.connectingSnapRadius = 40;
  // what was deleted comes back with undo or from the trash, so nobody is asked
  Blockly.dialog.setConfirm((_message, answer) => answer(true));
  adaptMenus();
  askOnlyDrawnFields();
  const workspace = Blockly.inject(options.container, {
    toolbox: toolbox(options.level),
    theme: blocklyTheme(options.theme),
    renderer: RENDERER,
    media: options.mediaPath,
    sounds: false,
    trashcan: true,
    maxTrashcanContents: 16,
    maxInstances: { program_start: 1 },
    collapse: false,
    comments: true,
    disable: false,
    modalInputs: false,
    move: { scrollbars: true, drag: true, wheel: true },
    zoom: { controls: false, wheel: false, pinch: true, startScale: 1, maxScale: 2, minScale: 0.4 },
  });
  registerFlyouts(workspace);
  keepCallsInStep(workspace);
  return workspace;
}
