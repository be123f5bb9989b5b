import * as Blockly from "blockly/core";
import { LETTERS } from "../../api/declared";
import { knownSigns } from "../known_signs";
import { blockText } from "../texts";
import { inOneStep } from "./name_field";
import { steerByKeys } from "./sign_menu_keys";

const OTHER = "\u0000other";
const FIRST = "B";
/** Maximum length of an answer that the server accepts, in characters. */
const MAX_LENGTH = 100;

/** The name of a sign. Its menu offers letters, taught signs, no sign, and any other name. */
export class SignField extends Blockly.FieldDropdown {
  private listing = false;
  private stopKeys: (() => void) | null = null;

  constructor(config?: Blockly.FieldDropdownConfig) {
    super(menu, undefined, config);
  }

  static override fromJson(options: Blockly.FieldDropdownFromJsonConfig): SignField {
    return new SignField(options);
  }

  /** The options. A closed menu has only the current sign: the full list is slow. */
  override getOptions(): Blockly.MenuOption[] {
    const current = this.getValue() ?? FIRST;
    if (!this.listing) return [[current || blockText("NO_SIGN"), current]];
    const named = knownSigns()?.named ?? [];
    const isListed = current === "" || [...LETTERS, ...named].includes(current);
    const names = [...named, ...(isListed ? [] : [current])];
    const others = [...names.filter(isShort), ...names.filter((name) => !isShort(name))].map(
      option,
    );
    return [
      ...LETTERS.map(option),
      "separator",
      ...(others.length > 0 ? ([...others, "separator"] as const) : []),
      [wide(blockText("NO_SIGN")), ""],
      [wide(blockText("OTHER_SIGN")), OTHER],
    ];
  }

  /** Accepts every name: a program may use a sign that the class has not taught. */
  protected override doClassValidation_(newValue?: unknown): string | null {
    return typeof newValue === "string" ? newValue : null;
  }

  protected override showEditor_(event?: MouseEvent): void {
    this.listing = true;
    super.showEditor_(event);
    this.listing = false;
    this.stopKeys = this.menu_ && steerByKeys(Blockly.DropDownDiv.getContentDiv(), this.menu_);
  }

  protected override dropdownDispose_(): void {
    this.stopKeys?.();
    this.stopKeys = null;
    super.dropdownDispose_();
  }

  protected override onItemSelected_(menu: Blockly.Menu, item: Blockly.MenuItem): void {
    if (item.getValue() === OTHER) this.ask();
    else super.onItemSelected_(menu, item);
  }

  private ask(): void {
    Blockly.dialog.prompt(blockText("ASK_SIGN"), this.getValue() ?? "", (answer) => {
      const name = answer?.trim().slice(0, MAX_LENGTH);
      if (name) inOneStep(() => this.setValue(name.length === 1 ? name.toUpperCase() : name));
    });
  }
}

function menu(this: Blockly.FieldDropdown): Blockly.MenuOption[] {
  return this.getOptions();
}

function option(name: string): Blockly.MenuOption {
  return [isShort(name) ? name : wide(name), name];
}

/** Whether the name is as narrow as a letter. */
function isShort(name: string): boolean {
  return name.length === 1;
}

/** A name of several letters, shown across several cells of the menu. */
function wide(text: string): HTMLElement {
  const element = document.createElement("span");
  element.className = "pinelSignName";
  element.textContent = text;
  element.title = text;
  return element;
}
