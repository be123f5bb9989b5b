import * as Blockly from "blockly/core";
import { isName } from "../names";
import { blockText } from "../texts";

/**
 * The name of a function or of a parameter, on the block that defines it. Any text may be typed;
 * when the edit ends, the field refuses an invalid or a duplicate name.
 */
export class DefinitionNameField extends Blockly.FieldTextInput {
  /** Whether another function or parameter has the name; set by the block. */
  declare isInUse?: (name: string) => boolean;
  private loading = false;
  private refused: string | null = null;

  static override fromJson(options: Blockly.FieldTextInputFromJsonConfig): DefinitionNameField {
    return new DefinitionNameField(options.text || blockText("FUNCTION_NAME"), undefined, options);
  }

  override loadState(state: unknown): void {
    this.load(String(state));
  }

  /** Sets a name from a saved program without checking it. */
  load(name: string): void {
    this.loading = true;
    this.setValue(name);
    this.loading = false;
  }

  protected override doClassValidation_(newValue?: unknown): string | null {
    const typed = String(newValue ?? "");
    if (this.loading) return typed;
    const name = typed.trim();
    const isDuplicate = isName(name) && this.isInUse?.(name);
    this.refused = !isName(name) ? blockText("NAME_REFUSED", this.getText()) : null;
    if (isDuplicate) this.refused = blockText("NAME_TAKEN", name);
    return this.refused === null ? name : null;
  }

  override onFinishEditing_(value: unknown): void {
    super.onFinishEditing_(value as string);
    const message = this.refused;
    this.refused = null;
    const workspace = this.getSourceBlock()?.workspace;
    if (message && workspace instanceof Blockly.WorkspaceSvg) {
      Blockly.Toast.show(workspace, { id: "pinel-name", message });
    }
  }
}
