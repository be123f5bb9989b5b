import * as Blockly from "blockly/core";
import { ALL_DEFINITIONS, type Row } from "./definitions";
import { DefinitionNameField } from "./fields/definition_name_field";
import { IconField } from "./fields/icon_field";
import { MeasureField } from "./fields/measure_field";
import { NameField } from "./fields/name_field";
import { SignField } from "./fields/sign_field";
import { iconArgument, iconSource } from "./icons";
import { branches } from "./shapes/branches";
import { callShape } from "./shapes/call";
import { functionShape } from "./shapes/function";
import { listData } from "./shapes/list_data";
import { variadic } from "./shapes/variadic";
import type { TextKey } from "./texts";
import { reference } from "./texts";

export { ALL_DEFINITIONS, type BlockType, CATEGORIES, DEFINITIONS } from "./definitions";
export { type Category, HUES } from "./hues";

let registered = false;

/**
 * Registers every block with Blockly. Only this function has that side effect; a second call does
 * nothing.
 */
export function registerBlocks(): void {
  if (registered) return;
  registered = true;
  registerFields();
  registerShapes();
  Blockly.common.defineBlocks(
    Blockly.common.createBlockDefinitionsFromJsonArray(ALL_DEFINITIONS.map(blocklyJson)),
  );
}

function registerFields(): void {
  Blockly.fieldRegistry.register("field_icon", IconField);
  Blockly.fieldRegistry.register("field_measure", MeasureField);
  Blockly.fieldRegistry.register("field_name", NameField);
  Blockly.fieldRegistry.register("field_function_name", DefinitionNameField);
  Blockly.fieldRegistry.register("field_sign", SignField);
}

function registerShapes(): void {
  Blockly.Extensions.registerMutator("pinel_branches", ...branches);
  Blockly.Extensions.registerMutator("pinel_variadic", ...variadic);
  Blockly.Extensions.registerMutator("pinel_list_data", ...listData);
  Blockly.Extensions.registerMutator("pinel_function", ...functionShape);
  Blockly.Extensions.registerMutator("pinel_call", ...callShape);
  Blockly.Extensions.register("turn_arrow", turnArrow);
  Blockly.Extensions.register("quiet_colour", quietColour);
}

/** Blockly's JSON of a row: with its text, and its icon as the first argument. */
function blocklyJson(row: Row): object {
  const { level, makes, icon, args0, variadic: _, hidden, ...json } = row;
  const key = row.type.toUpperCase() as TextKey;
  return {
    ...json,
    args0: icon ? [iconArgument(icon), ...args0] : args0,
    inputsInline: true,
    message0: reference(key),
    tooltip: reference(`${key}_TIP` as TextKey),
    helpUrl: "",
  };
}

/** Makes the arrow of a turn block point in the chosen direction. */
function turnArrow(this: Blockly.Block): void {
  const arrow = this.getField("ICON");
  this.getField("DIRECTION")?.setValidator((direction: string) => {
    arrow?.setValue(iconSource(direction === "LEFT" ? "rotateLeft" : "rotateRight"), false);
    return undefined;
  });
}

/** Hides the colour of a lifted pen, unless the document sets one. */
function quietColour(this: Blockly.Block): void {
  const colour = this.getField("COLOR");
  colour?.setVisible(false);
  colour?.setValidator((value: string) => {
    colour.setVisible(value !== "");
    return undefined;
  });
}
