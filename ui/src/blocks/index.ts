import * as Blockly from "blockly/core";
import { ALL_DEFINITIONS } from "./definitions";
import { IconField } from "./icon_field";
import { iconSource } from "./icons";
import { MeasureField } from "./measure_field";
import { reference } from "./texts";
import type { TextKey } from "./texts/keys";

export { ALL_DEFINITIONS, type BlockType, CATEGORIES, DEFINITIONS } from "./definitions";
export { type Category, HUES } from "./hues";

let registered = false;

/** Makes every block known to Blockly. The only place with that side effect; calling it again does nothing. */
export function registerBlocks(): void {
  if (registered) return;
  registered = true;
  Blockly.fieldRegistry.register("field_icon", IconField);
  Blockly.fieldRegistry.register("field_measure", MeasureField);
  Blockly.Extensions.register("turn_arrow", turnArrow);
  Blockly.common.defineBlocks(
    Blockly.common.createBlockDefinitionsFromJsonArray(ALL_DEFINITIONS.map(withTexts)),
  );
}

function withTexts(definition: (typeof ALL_DEFINITIONS)[number]): object {
  const key = definition.type.toUpperCase() as TextKey;
  return {
    ...definition,
    message0: reference(key),
    tooltip: reference(`${key}_TIP` as TextKey),
    helpUrl: "",
  };
}

/** The arrow on a turn shows the way it goes. */
function turnArrow(this: Blockly.Block): void {
  const arrow = this.getField("ICON");
  this.getField("DIRECTION")?.setValidator((direction: string) => {
    arrow?.setValue(iconSource(direction === "LEFT" ? "rotateLeft" : "rotateRight"), false);
    return undefined;
  });
}
