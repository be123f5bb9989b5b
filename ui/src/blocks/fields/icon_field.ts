import * as Blockly from "blockly/core";

/**
 * A decorative picture, hidden from screen readers: the text of the block has the same information.
 */
export class IconField extends Blockly.FieldImage {
  override computeAriaLabel(): string {
    return "";
  }
}
