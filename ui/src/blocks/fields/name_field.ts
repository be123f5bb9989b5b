import * as Blockly from "blockly/core";
import { isName, namesFor, renameVariable, type VariableField } from "../names";
import { blockText } from "../texts";

const NEW = "\u0000new";
const RENAME = "\u0000rename";

/** The name of a variable. Its menu offers the names in use, a new name, and renaming. */
export class NameField extends Blockly.FieldDropdown implements VariableField {
  readonly holdsVariable = true;
  private listing = false;

  constructor(config?: Blockly.FieldDropdownConfig) {
    super(menu, undefined, config);
  }

  static override fromJson(options: Blockly.FieldDropdownFromJsonConfig): NameField {
    return new NameField(options);
  }

  name_(): string {
    return String(this.getValue());
  }

  /** The options. A closed menu has only the current name: collecting all names is slow. */
  override getOptions(): Blockly.MenuOption[] {
    const current = this.getValue() ?? blockText("VARIABLE_NAME");
    if (!this.listing) return [[current, current]];
    const block = this.getSourceBlock();
    const names = new Set([current, ...(block ? namesFor(block) : [])]);
    return [
      ...[...names].map((name): Blockly.MenuOption => [name, name]),
      "separator",
      [blockText("NEW_NAME"), NEW],
      [blockText("RENAME", current), RENAME],
    ];
  }

  protected override doClassValidation_(newValue?: unknown): string | null {
    return typeof newValue === "string" && newValue !== "" ? newValue : null;
  }

  protected override showEditor_(event?: MouseEvent): void {
    this.listing = true;
    super.showEditor_(event);
    this.listing = false;
  }

  protected override onItemSelected_(menu: Blockly.Menu, item: Blockly.MenuItem): void {
    const value = item.getValue();
    if (value === NEW) this.ask(blockText("ASK_NEW_NAME"), "", (name) => this.setValue(name));
    else if (value === RENAME) this.askForRename();
    else super.onItemSelected_(menu, item);
  }

  private askForRename(): void {
    const from = this.name_();
    this.ask(blockText("ASK_RENAME", from), from, (to) => {
      const block = this.getSourceBlock();
      if (block) renameVariable(block, from, to);
    });
  }

  private ask(question: string, suggestion: string, apply: (name: string) => void): void {
    Blockly.dialog.prompt(question, suggestion, (answer) => {
      const name = answer?.trim();
      if (!name) return;
      if (isName(name)) inOneStep(() => apply(name));
      else this.refuse();
    });
  }

  private refuse(): void {
    const workspace = this.getSourceBlock()?.workspace;
    if (!(workspace instanceof Blockly.WorkspaceSvg)) return;
    const message = blockText("NAME_REFUSED", this.name_());
    Blockly.Toast.show(workspace, { id: "pinel-name", message });
  }
}

function menu(this: Blockly.FieldDropdown): Blockly.MenuOption[] {
  return this.getOptions();
}

/** Groups the changes of one user action, so that one undo reverts all of them. */
export function inOneStep(act: () => void): void {
  const before = Blockly.Events.getGroup();
  if (!before) Blockly.Events.setGroup(true);
  try {
    act();
  } finally {
    Blockly.Events.setGroup(before);
  }
}
