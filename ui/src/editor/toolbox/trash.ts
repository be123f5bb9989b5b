import * as Blockly from "blockly/core";
import { blockText } from "../../blocks/texts";
import { svgIcon } from "../svg_icon";

const CROSS = "M6 6l12 12M18 6L6 18";

/**
 * Closes the list of deleted blocks by its own button, by Escape, by a press anywhere else, and once a
 * block was dragged out.
 * Blockly closes it only by a press on the free workspace, and the list covers its bin.
 */
export function addTrashClosing(workspace: Blockly.WorkspaceSvg) {
  const ends = new AbortController();
  const { signal } = ends;
  const close = () => workspace.trashcan?.closeFlyout();
  const button = closeButton(close);
  // in front of the list, which Blockly puts right behind the workspace
  workspace.getInjectionDiv().append(button);
  const onPress = (event: Event) => {
    if (isInList(event.target) || button.contains(event.target as Node)) return;
    close();
  };
  const onKey = (event: KeyboardEvent) => {
    if (event.key === "Escape") close();
  };
  document.addEventListener("pointerdown", onPress, { capture: true, signal });
  document.addEventListener("keydown", onKey, { signal });
  workspace.addChangeListener((event) => {
    if (event.type === Blockly.Events.BLOCK_DRAG && !(event as Drag).isStart) close();
  });
  const relabel = () => {
    const [label] = button.getElementsByTagName("span");
    if (label) label.textContent = blockText("CLOSE_TRASH");
  };
  relabel();
  return { relabel, remove: () => ends.abort() };
}

type Drag = Blockly.Events.BlockDrag;

function isInList(target: EventTarget | null): boolean {
  return target instanceof Element && target.closest(".blocklyTrashcanFlyout") !== null;
}

function closeButton(close: () => void): HTMLButtonElement {
  const button = document.createElement("button");
  button.type = "button";
  button.className = "pinelTrashClose";
  button.dataset.testid = "trash-close";
  button.append(svgIcon(CROSS, "pinelZoomIcon"), document.createElement("span"));
  button.addEventListener("click", close);
  return button;
}
