import * as Blockly from "blockly/core";

/**
 * Calls back once after each burst of events that changed the program. Ignores selecting, scrolling
 * and opening a menu, and a drag until it ends.
 */
export function watchContent(workspace: Blockly.WorkspaceSvg, changed: () => void): void {
  let scheduled = false;
  workspace.addChangeListener((event) => {
    if (scheduled || !touchesContent(event) || workspace.isDragging()) return;
    scheduled = true;
    queueMicrotask(() => {
      scheduled = false;
      changed();
    });
  });
}

function touchesContent(event: Blockly.Events.Abstract): boolean {
  return !event.isUiEvent || event.type === Blockly.Events.BLOCK_DRAG;
}
