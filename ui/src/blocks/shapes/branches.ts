import type * as Blockly from "blockly/core";
import { buttonField } from "../fields/button_field";
import { IconField } from "../fields/icon_field";
import { rowSpacer } from "../icons";
import { blockText } from "../texts";
import { changeShape } from "./change_shape";

/** How many "else if" branches an `if` has, and whether it has an "else". */
export interface BranchesState {
  elif?: number;
  else?: boolean;
}

interface IfBlock extends Blockly.Block {
  elifCount: number;
  hasElse: boolean;
  plus(): void;
  minusElse(): void;
  minusElif(index: number): void;
  shape(elifCount: number, hasElse: boolean): void;
}

const mixin = {
  elifCount: 0,
  hasElse: false,

  saveExtraState(this: IfBlock): BranchesState | null {
    if (this.elifCount === 0 && !this.hasElse) return null;
    return {
      ...(this.elifCount > 0 && { elif: this.elifCount }),
      ...(this.hasElse && { else: true }),
    };
  },

  loadExtraState(this: IfBlock, state: BranchesState): void {
    this.shape(state.elif ?? 0, state.else ?? false);
  },

  /** Adds an "else" first, then one "else if" per call. */
  plus(this: IfBlock): void {
    changeShape(this, () => this.shape(this.elifCount + (this.hasElse ? 1 : 0), true));
  },

  minusElse(this: IfBlock): void {
    changeShape(this, () => this.shape(this.elifCount, false));
  },

  minusElif(this: IfBlock, index: number): void {
    changeShape(this, () => {
      for (const name of ["CONDITION", "THEN"]) {
        this.getInputTargetBlock(name + index)?.unplug();
        for (let next = index + 1; next <= this.elifCount; next++) {
          moveChild(this, name + next, name + (next - 1));
        }
      }
      this.shape(this.elifCount - 1, this.hasElse);
    });
  },

  shape(this: IfBlock, elifCount: number, hasElse: boolean): void {
    while (this.elifCount > elifCount) removeElif(this, this.elifCount--);
    while (this.elifCount < elifCount) addElif(this, ++this.elifCount);
    if (this.hasElse !== hasElse) {
      this.hasElse = hasElse;
      if (hasElse) addElse(this);
      else for (const name of ["ELSE_LABEL", "ELSE"]) this.removeInput(name);
    }
  },
};

function addElif(block: IfBlock, index: number): void {
  const before = block.hasElse ? "ELSE_LABEL" : null;
  const button = buttonField("minus", blockText("MINUS_BRANCH"), () => block.minusElif(index));
  block
    .appendValueInput(`CONDITION${index}`)
    .setCheck("Boolean")
    .appendField(spacer())
    .appendField(blockText("ELSE_IF"));
  block.appendDummyInput(`LABEL${index}`).appendField(blockText("THEN")).appendField(button);
  block.appendStatementInput(`THEN${index}`);
  for (const name of ["CONDITION", "LABEL", "THEN"]) block.moveInputBefore(name + index, before);
}

function removeElif(block: IfBlock, index: number): void {
  for (const name of ["CONDITION", "LABEL", "THEN"]) block.removeInput(name + index);
}

function addElse(block: IfBlock): void {
  block
    .appendDummyInput("ELSE_LABEL")
    .appendField(spacer())
    .appendField(blockText("ELSE"))
    .appendField(buttonField("minus", blockText("MINUS_BRANCH"), () => block.minusElse()));
  block.appendStatementInput("ELSE");
}

function spacer(): IconField {
  return new IconField(rowSpacer.src, rowSpacer.width, rowSpacer.height);
}

function moveChild(block: Blockly.Block, from: string, to: string): void {
  const child = block.getInputTargetBlock(from);
  if (!child) return;
  child.unplug();
  const connection = child.outputConnection ?? child.previousConnection;
  if (connection) block.getInput(to)?.connection?.connect(connection);
}

function helper(this: Blockly.Block): void {
  const block = this as IfBlock;
  block
    .appendDummyInput("PLUS")
    .appendField(buttonField("plus", blockText("PLUS_BRANCH"), () => block.plus()));
  block.moveInputBefore("PLUS", "THEN");
}

export const branches = [mixin, helper] as const;
