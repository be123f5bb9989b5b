import * as Blockly from "blockly/core";
import { registerBlocks } from "../blocks";
import type { Level } from "../blocks/definition";
import type { BlockType } from "../blocks/definitions";
import { flyoutBlock, offeredRows } from "../blocks/toolbox/toolbox";
import type { Language } from "../i18n";
import { type BlockDrawing, drawn, onStage, stageClassesOf } from "./block_drawings";
import { applyLanguage } from "./locale";
import { registerRenderer } from "./renderer";
import { patchAriaUpdates } from "./without_events";

/** A block on paper: its values are blanks, and its mouths have room for other cards. */
export interface BlockCard extends Pick<BlockDrawing, "text" | "svg"> {
  /** Type of the block, and the option that is printed on it. */
  readonly name: string;
}

/** The blocks of the lesson of two hours. */
export const LESSON_BLOCKS: readonly BlockType[] = [
  "move_forward",
  "turn",
  "repeat",
  "pen_down",
  "pen_up",
  "classify_gestures",
  "if",
  "compare",
];

/** Calls say what they call, which is not known on paper. */
const NOT_ON_PAPER: readonly BlockType[] = ["call", "call_value"];
/** Room for a number of three digits in pencil. */
const BLANK = "\u00a0".repeat(9);
/** A menu with more options is a blank; one with fewer gives a card for each. */
const MAX_OPTIONS = 2;
/** Room in a mouth, in blocks. */
const N_FILLING_BLOCKS = 2;

/** Draws the cards of a level, or of these blocks. */
export function drawCards(language: Language, which: Level | readonly BlockType[]): BlockCards {
  applyLanguage(language);
  registerBlocks();
  registerRenderer();
  patchAriaUpdates();
  const types = typeof which === "number" ? offeredRows(which).map(({ type }) => type) : which;
  return onStage("light", (workspace) => ({
    stageClasses: stageClassesOf(workspace),
    cards: types
      .filter((type) => !NOT_ON_PAPER.includes(type))
      .flatMap((type) => cardsOf(type, workspace)),
  }));
}

export interface BlockCards {
  /** Classes of an element around the drawings, which Blockly's own styles depend on. */
  readonly stageClasses: string;
  readonly cards: readonly BlockCard[];
}

function cardsOf(type: BlockType, workspace: Blockly.WorkspaceSvg): BlockCard[] {
  let options: readonly string[] = [""];
  const card = (index: number): BlockCard => {
    const picture = drawn(flyoutBlock(type, 3, workspace), workspace, (block) => {
      const menu = shortMenu(block);
      if (menu) options = valuesOf(menu);
      menu?.setValue(options[index]);
      for (const one of block.getDescendants(false)) makeBlank(one, menu);
      openStatementInputs(block);
    });
    for (const filling of picture.svg.querySelectorAll(`.${FILLING}`)) filling.remove();
    // Blockly insists on white words in menus
    for (const text of picture.svg.querySelectorAll(".blocklyDropdownText")) {
      text.classList.remove("blocklyDropdownText");
    }
    return { ...picture, name: [type, options[index]].filter(Boolean).join(" ") };
  };
  const first = card(0);
  return [first, ...options.slice(1).map((_, index) => card(index + 1))];
}

function shortMenu(block: Blockly.Block): Blockly.FieldDropdown | null {
  const menus = [...block.getFields()].filter((field) => field instanceof Blockly.FieldDropdown);
  return menus.find((menu) => menu.getOptions(false).length <= MAX_OPTIONS) ?? null;
}

function valuesOf(menu: Blockly.FieldDropdown): string[] {
  return menu.getOptions(false).flatMap((one) => (Array.isArray(one) ? [one[1]] : []));
}

/** Shows nothing where a value stands, with room to write it. */
function makeBlank(block: Blockly.Block, but: Blockly.Field | null): void {
  for (const field of block.getFields()) {
    if (field instanceof Blockly.FieldImage && field.isClickable()) field.setVisible(false);
    if (!field.EDITABLE || field === but) continue;
    Object.assign(field, { getDisplayText_: () => BLANK });
    field.getSvgRoot()?.classList.add("cardBlank");
    field.forceRerender();
  }
}

const FILLING = "cardFilling";

/** Opens each mouth of a block with blocks that are not drawn. */
function openStatementInputs(block: Blockly.BlockSvg): void {
  for (const input of block.inputList) {
    if (input.type !== Blockly.inputs.inputTypes.STATEMENT) continue;
    let below: Blockly.Connection | null = input.connection;
    for (let n = 0; n < N_FILLING_BLOCKS && below; n++) {
      const filling = block.workspace.newBlock("stop") as Blockly.BlockSvg;
      filling.initSvg();
      filling.getSvgRoot().classList.add(FILLING);
      if (filling.previousConnection) below.connect(filling.previousConnection);
      below = filling.nextConnection;
    }
  }
}
