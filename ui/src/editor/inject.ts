import * as Blockly from "blockly/core";
import { syncCalls } from "../blocks/shapes/function_sync";
import { type OfferedActions, registerFlyouts, toolbox } from "../blocks/toolbox/toolbox";
import { patchOrphans, WRAPPING_PLUGINS } from "./dragging/wrapping";
import { patchFieldEditors } from "./field_editors";
import { adaptMenus } from "./menus";
import type { EditorOptions } from "./options";
import { RENDERER, registerRenderer } from "./renderer";
import { blocklyTheme } from "./themes";
import { patchFlyoutClicks } from "./toolbox/append";
import { TOOLBOX_PLUGINS } from "./toolbox/flyout";
import { patchFlyoutRoles } from "./toolbox/flyout_roles";
import { registerSearchItem } from "./toolbox/search_item";
import { registerToolboxCategory } from "./toolbox/toolbox_category";
import { patchAriaUpdates } from "./without_events";

/** Injects a Blockly workspace with our renderer, theme and toolbox into the container. */
export function injectWorkspace(
  options: EditorOptions,
  offered: () => OfferedActions,
): Blockly.WorkspaceSvg {
  registerRenderer();
  registerToolboxCategory();
  registerSearchItem();
  // fingers and shared mice often drop a block far from the connection that they aim at
  Blockly.config.snapRadius = 40;
  Blockly.config.connectingSnapRadius = 40;
  // a deleted block can be restored by undo or from the trash, so no confirmation is needed
  Blockly.dialog.setConfirm((_message, answer) => answer(true));
  adaptMenus();
  patchAriaUpdates();
  patchFieldEditors();
  patchFlyoutClicks();
  patchFlyoutRoles();
  patchOrphans();
  const workspace = Blockly.inject(options.container, {
    toolbox: toolbox(options.level, offered()),
    theme: blocklyTheme(options.theme),
    renderer: RENDERER,
    css: false, // the renderer adds it
    plugins: { ...TOOLBOX_PLUGINS, ...WRAPPING_PLUGINS },
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
  syncCalls(workspace);
  return workspace;
}
