import * as Blockly from "blockly/core";

const SHOWN_MS = 7000;
const GAP_PX = 8;

interface Note {
  readonly field: Blockly.Field;
  readonly element: HTMLElement;
  hide(): void;
}

let shown: Note | null = null;

/**
 * Shows a note at a field and announces it to a screen reader. The next edit or a timeout of some
 * seconds hides the note.
 */
export function showFieldNote(field: Blockly.Field, text: string): void {
  const workspace = field.getSourceBlock()?.workspace;
  if (!(workspace instanceof Blockly.WorkspaceSvg)) return;
  shown?.hide();
  shown = newNote(field, workspace);
  shown.element.textContent = text;
  place(shown);
  Blockly.utils.aria.announceDynamicAriaState(text);
}

/** Like `showFieldNote`, but appends the text to the note that the field shows already. */
export function addToFieldNote(field: Blockly.Field, text: string): void {
  const before = shown?.field === field ? `${shown.element.textContent} ` : "";
  if (!before.includes(text)) showFieldNote(field, before + text);
}

function newNote(field: Blockly.Field, workspace: Blockly.WorkspaceSvg): Note {
  const element = document.createElement("div");
  element.className = "pinelFieldNote";
  element.dataset.testid = "field-note";
  workspace.getInjectionDiv().append(element);
  const value = field.getValue();
  const onEvent = (event: Blockly.Events.Abstract) => {
    if (!isChangeTo(value, event, field) && isEditOrMove(event)) note.hide();
  };
  const timer = window.setTimeout(() => note.hide(), SHOWN_MS);
  const note = {
    field,
    element,
    hide() {
      window.clearTimeout(timer);
      workspace.removeChangeListener(onEvent);
      element.remove();
      if (shown === note) shown = null;
    },
  };
  workspace.addChangeListener(onEvent);
  return note;
}

/**
 * Whether the event reports the edit that caused the note; Blockly fires it after the note appears.
 */
function isChangeTo(value: unknown, event: Blockly.Events.Abstract, field: Blockly.Field): boolean {
  const { blockId, newValue } = event as Partial<Blockly.Events.BlockChange>;
  return blockId === field.getSourceBlock()?.id && newValue === value;
}

function isEditOrMove(event: Blockly.Events.Abstract): boolean {
  return !event.isUiEvent || event.type === Blockly.Events.VIEWPORT_CHANGE;
}

/** Places the note below the field, or above the field if the workspace ends there. */
function place({ field, element }: Note): void {
  const around = element.parentElement?.getBoundingClientRect();
  const root = field.getSvgRoot()?.getBoundingClientRect();
  if (!around || !root) return;
  const { offsetWidth: width, offsetHeight: height } = element;
  const right = around.width - width - GAP_PX;
  const below = root.bottom - around.top + GAP_PX;
  const above = root.top - around.top - GAP_PX - height;
  element.style.left = `${Math.max(GAP_PX, Math.min(root.left - around.left, right))}px`;
  element.style.top = `${below + height > around.height ? above : below}px`;
}
