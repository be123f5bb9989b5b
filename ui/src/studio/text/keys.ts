import { listen } from "../../kit/listen";
import { type Change, indent, newLine, outdent } from "./typing";

/**
 * Gives a text area the usual indentation by Enter and Tab; Ctrl+Enter calls `done`. After Escape the next Tab moves the
 * focus, so that keyboard users can leave the field.
 */
export function listenToTyping(field: HTMLTextAreaElement, done: () => void): () => void {
  let leaving = false;
  const onKey = (event: KeyboardEvent) => {
    const { key } = event;
    if (event.isComposing) return;
    if (key === "Escape") leaving = true;
    else if (key === "Enter" && (event.ctrlKey || event.metaKey)) act(event, done);
    else if (key === "Enter") act(event, () => make(field, newLine));
    else if (key === "Tab" && !leaving) {
      act(event, () => make(field, event.shiftKey ? outdent : indent));
    } else if (key !== "Shift") leaving = false;
  };
  return listen(field, { keydown: onKey });
}

function act(event: KeyboardEvent, what: () => void): void {
  event.preventDefault();
  what();
}

type Edit = (text: string, selected: { start: number; end: number }) => Change;

function make(field: HTMLTextAreaElement, edit: Edit): void {
  const { value, selectionStart, selectionEnd } = field;
  const { from, to, text, after } = edit(value, { start: selectionStart, end: selectionEnd });
  if (value.slice(from, to) === text) return;
  field.setSelectionRange(from, to);
  // deprecated, but the only edit that preserves the browser's undo stack
  if (!document.execCommand("insertText", false, text)) {
    field.setRangeText(text);
    field.dispatchEvent(new InputEvent("input", { bubbles: true }));
  }
  field.setSelectionRange(after.start, after.end);
}
