import * as Blockly from "blockly/core";

/** What Blockly's fields do to open their editors; protected in its types. */
interface Inputs {
  widgetCreate_(this: Blockly.Field): HTMLElement;
}
interface Menus {
  showEditor_(this: MenuField, event?: MouseEvent): void;
}
type MenuField = Blockly.Field & { readonly menu_: Blockly.Menu | null };

let patched = false;

/** Gives the open editor of a field the name that the field has for screen readers; Blockly gives it none. */
export function patchFieldEditors(): void {
  if (patched) return;
  patched = true;
  // the class of text and number fields, which Blockly does not export
  const inputs = Object.getPrototypeOf(Blockly.FieldTextInput.prototype) as Inputs;
  const { widgetCreate_: create } = inputs;
  inputs.widgetCreate_ = function () {
    return named(create.call(this), this);
  };
  const menus = Blockly.FieldDropdown.prototype as unknown as Menus;
  const { showEditor_: open } = menus;
  menus.showEditor_ = function (event) {
    open.call(this, event);
    const list = this.menu_?.getElement();
    if (list) named(list, this);
  };
}

function named<T extends HTMLElement>(element: T, field: Blockly.Field): T {
  element.setAttribute("aria-label", field.computeAriaLabel(true));
  return element;
}
