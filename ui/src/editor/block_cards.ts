import * as Blockly from "blockly/core";
import { registerBlocks } from "../blocks";
import type { Level } from "../blocks/definition";
import type { BlockType } from "../blocks/definitions";
import { ButtonField } from "../blocks/fields/button_field";
import { flyoutBlock, offeredRows } from "../blocks/toolbox/toolbox";
import type { Language } from "../i18n";
import { type BlockDrawing, drawn, onStage, stageClassesOf } from "./block_drawings";
import { applyLanguage } from "./locale";
import { registerRenderer } from "./renderer";
import { patchAriaUpdates } from "./without_events";

/**
 * A block on a printed card: its values are blanks, and its statement inputs have space for other
 * cards.
 */
export interface BlockCard extends Pick<BlockDrawing, "text" | "svg"> {
  /** Type of the block, and the menu option that is printed on it. */
  readonly name: string;
}

/** The blocks of the two-hour lesson. */
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

/** Calls show the name of their function, which does not exist on paper. */
const NOT_ON_PAPER: readonly BlockType[] = ["call", "call_value"];
/** Blank for a number of three digits in pencil. */
const BLANK = "\u00a0".repeat(9);
/** A menu with more options is printed as a blank; a shorter menu gives one card per option. */
const MAX_OPTIONS = 2;
/** Height of an empty statement input, in blocks. */
const N_FILLING_BLOCKS = 2;

/** Draws the cards of a level, or of a list of block types. */
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
  /** Classes for an element around the drawings; Blockly's style sheet depends on them. */
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
    // Blockly's style sheet makes the text of menus white, with !important
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

/** Hides the values of a block and widens their fields, so that pupils can write there. */
function makeBlank(block: Blockly.Block, but: Blockly.Field | null): void {
  for (const field of block.getFields()) {
    if (field instanceof ButtonField) field.setVisible(false);
    if (!field.EDITABLE || field === but) continue;
    Object.assign(field, { getDisplayText_: () => BLANK });
    field.getSvgRoot()?.classList.add("cardBlank");
    field.forceRerender();
  }
}

const FILLING = "cardFilling";

/** Widens each statement input of a block with blocks that are removed from the drawing. */
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
