import * as Blockly from "blockly/core";

/**
 * Blockly moves what it draws about in the page, and what is moved loses the keyboard's focus; on a slow PC it is not
 * always given back, and the next key goes nowhere. Gives it back, unless a pointer took it away.
 *
 * Returns what ends it.
 */
export function keepFocus(workspace: Blockly.WorkspaceSvg): () => void {
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
