import * as Blockly from "blockly/core";
import type { Limits } from "../definition";
import { argumentsOf, definitionOf } from "../definitions";
import { blockText } from "../texts";
import { showFieldNote } from "./field_note";

/** Maximum number of characters of a refused text that the message repeats. */
const MAX_TYPED = 16;

/**
 * A number with the decimal separator of the language, such as "0,5". Blockly's own field drops the
 * comma, so that a Brazilian half metre (0,5) would become five metres (05).
 *
 * A typed number is bounded by the limits of its input; a number of a saved program is shown
 * unchanged.
 */
export class MeasureField extends Blockly.FieldNumber {
  /** Typed text that is out of range or no number; the field reports it when the editor closes. */
  private refused: string | null = null;
  private loading = false;

  override loadState(state: unknown): void {
    this.loading = true;
    super.loadState(state);
    this.loading = false;
  }

  protected override doClassValidation_(newValue?: unknown): number | null {
    const { min, max, precision } = this.loading ? {} : this.limits();
    this.min_ = min ?? -Number.MAX_VALUE;
    this.max_ = max ?? Number.MAX_VALUE;
    this.setPrecisionOnly(precision ?? 0);
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
    if (typed !== null) this.showComplaint(typed);
  }

  static override fromJson(options: Blockly.FieldNumberFromJsonConfig): MeasureField {
    return new MeasureField(options.value, undefined, undefined, undefined, undefined, options);
  }

  /** The limits of the input into which the number is plugged. */
  private limits(): Limits {
    const place = this.getSourceBlock()?.outputConnection?.targetConnection;
    if (!place) return {};
    const name = place.getParentInput()?.name;
    const row = definitionOf(place.getSourceBlock().type);
    return argumentsOf(row).find((argument) => argument.name === name)?.limits ?? {};
  }

  /** Like `setPrecision`, but without validating the value again. */
  private setPrecisionOnly(precision: number): void {
    this.precision_ = precision;
    const decimals = String(precision).split(".")[1]?.length ?? 0;
    Object.assign(this, { decimalPlaces: precision ? decimals : null });
  }

  private accepts(text: string): boolean {
    const { min = -Infinity, max = Infinity } = this.limits();
    const value = Number(parseMeasure(text) || Number.NaN);
    return value >= min && value <= max;
  }

  private showComplaint(typed: string): void {
    showFieldNote(this, this.complaint(typed));
  }

  private complaint(typed: string): string {
    const current = this.getText();
    const { min, max } = this.limits();
    const text = shortened(typed.trim());
    if (text === "") return blockText("NUMBER_MISSING", current);
    if (Number.isNaN(Number(parseMeasure(typed)))) return blockText("NOT_A_NUMBER", text, current);
    if (max === undefined) return blockText("AT_LEAST", text, formatMeasure(min), current);
    return blockText("OUT_OF_RANGE", text, formatMeasure(min), formatMeasure(max), current);
  }
}

const shortened = (text: string) =>
  text.length > MAX_TYPED ? `${text.slice(0, MAX_TYPED)}…` : text;

function parseMeasure(value: unknown): string {
  return String(value ?? "")
    .trim()
    .replaceAll(",", ".");
}

function formatMeasure(value: unknown): string {
  return String(value ?? "").replace(".", blockText("DECIMAL_SEPARATOR") || ".");
}
