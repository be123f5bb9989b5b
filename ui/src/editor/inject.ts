import * as Blockly from "blockly/core";
import { keepCallsInStep } from "../blocks/shapes/function_sync";
import { type Offered, registerFlyouts, toolbox } from "../blocks/toolbox/toolbox";
import { adaptMenus } from "./menus";
import type { EditorOptions } from "./options";
import { patchAriaUpdates } from "./quietly";
import { RENDERER, registerRenderer } from "./renderer";
import { blocklyTheme } from "./themes";
import { patchPaletteClicks } from "./toolbox/append";
import { PALETTE_PLUGINS } from "./toolbox/palette";
import { registerSearchItem } from "./toolbox/search_item";
import { registerToolboxCategory } from "./toolbox/toolbox_category";

/** Injects a Blockly workspace with this application's renderer, theme and toolbox into the container. */
export function injectWorkspace(
  options: EditorOptions,
  offered: () => Offered,
): Blockly.WorkspaceSvg {
  registerRenderer();
  registerToolboxCategory();
  registerSearchItem();
  // a finger or a shared mouse often drops a block well beside the connection it aims at
  Blockly.config.snapRadius = 40;
  Blockly.config.connectingSnapRadius = 40;
  // a deleted block can be restored by undo or from the trash, so no confirmation is needed
  Blockly.dialog.setConfirm((_message, answer) => answer(true));
  adaptMenus();
  patchAriaUpdates();
  patchPaletteClicks();
  const workspace = Blockly.inject(options.container, {
    toolbox: toolbox(options.level, offered()),
    theme: blocklyTheme(options.theme),
    renderer: RENDERER,
    plugins: PALETTE_PLUGINS,
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
  registerFlyouts(workspace, offered);
  keepCallsInStep(workspace);
  return workspace;
}
