import * as Blockly from "blockly/core";
import { type IconName, iconSource } from "../icons";

/** A plus or minus button on a block, for pointer and keyboard. */
export function buttonField(icon: IconName, label: string, act: () => void): Blockly.FieldImage {
  return new Blockly.FieldImage(iconSource(icon), 26, 26, label, act);
}
