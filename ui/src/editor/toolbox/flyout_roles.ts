import * as Blockly from "blockly/core";

let patched = false;

/**
 * Hides the connections of palette blocks from assistive technology: nobody can reach them there,
 * and a listbox may hold options only.
 */
export function patchFlyoutRoles(): void {
  if (patched) return;
  patched = true;
  const { prototype } = Blockly.RenderedConnection;
  const { setAriaRole } = prototype;
  prototype.setAriaRole = function (this: Blockly.RenderedConnection, highlight: SVGElement) {
    if (!this.getSourceBlock().workspace.isFlyout) return setAriaRole.call(this, highlight);
    highlight.setAttribute("role", "none");
    highlight.setAttribute("aria-hidden", "true");
  };
}

/**
 * Says what a palette is: a listbox of blocks, or a group if it holds only a note. Blockly lets
 * each option own its connections, of which some are not in the page.
 */
export function showFlyoutRole(canvas: Element): void {
  const options = canvas.querySelectorAll('[role="option"]');
  for (const option of options) option.removeAttribute("aria-owns");
  canvas.setAttribute("role", options.length > 0 ? "listbox" : "group");
}
