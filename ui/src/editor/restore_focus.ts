import * as Blockly from "blockly/core";

/**
 * Restores keyboard focus after Blockly has moved elements in the page. On a slow PC Blockly does
 * not always restore it, and the next key is ignored. Focus that a pointer took away is not
 * restored.
 *
 * Returns the function that stops the restoring.
 */
export function restoreFocus(workspace: Blockly.WorkspaceSvg): () => void {
  const ends = new AbortController();
  const area = workspace.getInjectionDiv();
  let byKeyboard = false;
  const on = (type: string, act: (event: Event) => void) =>
    document.addEventListener(type, act, { capture: true, signal: ends.signal });

  const restore = () => {
    const focus = Blockly.getFocusManager();
    const isLost = document.activeElement === document.body && !focus.ephemeralFocusTaken();
    if (isLost && byKeyboard && !ends.signal.aborted) focus.focusTree(workspace);
  };
  on("keydown", () => {
    byKeyboard = true;
  });
  on("pointerdown", () => {
    byKeyboard = false;
  });
  on("focusout", (event) => {
    const { relatedTarget } = event as FocusEvent;
    if (relatedTarget === null && area.contains(event.target as Node)) setTimeout(restore, 0);
  });
  return () => ends.abort();
}
