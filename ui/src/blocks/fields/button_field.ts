import * as Blockly from "blockly/core";
import { type IconName, iconSource } from "../icons";

/** A plus or a minus on a block, for a finger and for the keyboard. */
export function buttonField(icon: IconName, label: string, act: () => void): Blockly.FieldImage {
  return new Blockly.FieldImage(iconSource(icon), 26, 26, label, act);
}
