import type * as Blockly from "blockly/core";
import { type BlockType, DEFINITIONS } from "./definitions";
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

/** The categories a pupil chooses from; the start block stands in the workspace already. */
export const TOOLBOX_CATEGORIES: readonly Exclude<Category, "start">[] = [
  "motion",
  "flow",
  "logic",
  "gestures",
];

export function toolbox(): Blockly.utils.toolbox.ToolboxInfo {
  return { kind: "categoryToolbox", contents: TOOLBOX_CATEGORIES.map(category) };
}

function category(name: Exclude<Category, "start">): Blockly.utils.toolbox.StaticCategoryInfo {
  return {
    kind: "category",
    id: name,
    name: reference(`CATEGORY_${name.toUpperCase()}` as TextKey),
    categorystyle: name,
    cssconfig: {},
    hidden: undefined,
    contents: DEFINITIONS[name].map(({ type }) => ({ kind: "block", type, ...FILLED[type] })),
  } as unknown as Blockly.utils.toolbox.StaticCategoryInfo;
}
