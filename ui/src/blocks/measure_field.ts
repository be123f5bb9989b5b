import * as Blockly from "blockly/core";
import { word } from "./texts";

/**
 * A number as pupils write it: "0,5" where the language writes decimals with a comma. Blockly's own field drops the
 * comma, so that a Brazilian half metre would become five metres.
 */
export class MeasureField extends Blockly.FieldNumber {
  /** Typed last and out of range or no number at all; told once the editor closes. */
  private refused: string | null = null;

  protected override doClassValidation_(newValue?: unknown): number | null {
    return super.doClassValidation_(parseMeasure(newValue));
  }

  protected override getText_(): string {
    return formatMeasure(this.getValue());
  }

  protected override getEditorText_(value: unknown): string {
    return formatMeasure(value);
  }

  protected override getValueFromEditorText_(text: string): string {
    this.refused = this.accepts(text) ? null : text;
    return text;
  }

  protected override widgetCreate_(): HTMLInputElement {
    const input = super.widgetCreate_() as HTMLInputElement;
    input.inputMode = "decimal";
    return input;
  }

  override onFinishEditing_(value: unknown): void {
    super.onFinishEditing_(value);
    const typed = this.refused;
    this.refused = null;
    if (typed !== null) this.tell(typed);
  }

  private accepts(text: string): boolean {
    const value = Number(parseMeasure(text) || Number.NaN);
    return value >= this.getMin() && value <= this.getMax();
  }

  private tell(typed: string): void {
    const workspace = this.getSourceBlock()?.workspace;
    if (!(workspace instanceof Blockly.WorkspaceSvg)) return;
    const kept = this.getText();
    const message = Number.isNaN(Number(parseMeasure(typed) || Number.NaN))
      ? word("NOT_A_NUMBER", kept)
      : word("OUT_OF_RANGE", formatMeasure(this.getMin()), formatMeasure(this.getMax()), kept);
    Blockly.Toast.show(workspace, { id: "pinel-range", message });
  }
}

function parseMeasure(value: unknown): string {
  return String(value ?? "")
    .trim()
    .replaceAll(",", ".");
}

function formatMeasure(value: unknown): string {
  return String(value ?? "").replace(".", word("DECIMAL_SEPARATOR") || ".");
}
