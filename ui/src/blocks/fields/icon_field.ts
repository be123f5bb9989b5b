import * as Blockly from "blockly/core";

/** A picture that says nothing its block does not say in words: a screen reader passes over it. */
export class IconField extends Blockly.FieldImage {
  override computeAriaLabel(): string {
    return "";
  }
}
