import * as Blockly from "blockly/core";
import { type IconName, iconSource } from "../icons";

/** A plus or minus button on a block, for pointer and keyboard. */
export class ButtonField extends Blockly.FieldImage {}

export function buttonField(icon: IconName, label: string, act: () => void): ButtonField {
  return new ButtonField(iconSource(icon), 26, 26, label, act);
}
