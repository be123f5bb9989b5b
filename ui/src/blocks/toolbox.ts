import type * as Blockly from "blockly/core";
import { type BlockType, CATEGORIES, DEFINITIONS } from "./definitions";
import type { Category } from "./hues";
import { reference } from "./texts";
import type { TextKey } from "./texts/keys";

type ToolboxBlock = Blockly.utils.toolbox.BlockInfo;

const letter = { shadow: { type: "text_letter", fields: { TEXT: "B" } } };
const gestureIsLetter = {
  block: {
    type: "compare",
    inputs: { A: { block: { type: "gesture_result" } }, B: letter },
  },
};

/** Blocks that come out of the toolbox with something in their holes, because an empty one says little. */
const FILLED: Partial<Record<BlockType, Pick<ToolboxBlock, "inputs">>> = {
  if: { inputs: { CONDITION: gestureIsLetter } },
  if_else: { inputs: { CONDITION: gestureIsLetter } },
  compare: { inputs: gestureIsLetter.block.inputs },
};

type ToolboxCategory = Exclude<Category, "start">;

/** The categories a pupil chooses from; the start block stands in the workspace already. */
export const TOOLBOX_CATEGORIES = CATEGORIES.filter(
  (category): category is ToolboxCategory => category !== "start",
);

export function toolbox(): Blockly.utils.toolbox.ToolboxInfo {
  return { kind: "categoryToolbox", contents: TOOLBOX_CATEGORIES.map(category) };
}

function category(name: ToolboxCategory): Blockly.utils.toolbox.StaticCategoryInfo {
  return {
    kind: "category",
    id: name,
    name: reference(`CATEGORY_${name.toUpperCase()}` as TextKey),
    categorystyle: name,
    contents: DEFINITIONS[name].map(({ type }) => ({ kind: "block", type, ...FILLED[type] })),
    colour: undefined,
    cssconfig: undefined,
    hidden: undefined,
  };
}
