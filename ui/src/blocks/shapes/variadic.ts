import * as Blockly from "blockly/core";
import type { Variadic } from "../definition";
import { definitionOf } from "../definitions";
import { buttonField } from "../fields/button_field";
import { blockText } from "../texts";
import { changeShape } from "./change_shape";
import { shadowState } from "./shadows";

export interface VariadicState {
  n: number;
}

interface VariadicBlock extends Blockly.Block {
  itemCount: number;
  plus(): void;
  minus(): void;
  shape(count: number, filled: boolean): void;
}

/** The name of an input by its index. The first two match blocks with two fixed inputs. */
export function itemInput(index: number): string {
  return ["A", "B"][index] ?? `ARG${index}`;
}

function optionsOf(block: Blockly.Block): Variadic {
  const { variadic } = definitionOf(block.type);
  if (!variadic) throw new Error(`${block.type} has a fixed number of inputs`);
  return variadic;
}

const mixin = {
  itemCount: 0,

  saveExtraState(this: VariadicBlock): VariadicState | null {
    return this.itemCount === optionsOf(this).start ? null : { n: this.itemCount };
  },

  loadExtraState(this: VariadicBlock, state: Partial<VariadicState>): void {
    // while loading, the saved state fills the inputs; undo must add the placeholders itself
    const inUse = this.inputList.some((input) => input.connection?.isConnected());
    this.shape(state.n ?? optionsOf(this).start, inUse);
  },

  plus(this: VariadicBlock): void {
    changeShape(this, () => this.shape(this.itemCount + 1, true));
  },

  minus(this: VariadicBlock): void {
    changeShape(this, () => this.shape(this.itemCount - 1, true));
  },

  shape(this: VariadicBlock, count: number, filled: boolean): void {
    if (this.getInput("BUTTONS")) this.removeInput("BUTTONS");
    while (this.itemCount > count) this.removeInput(itemInput(--this.itemCount));
    while (this.itemCount < count) addItem(this, this.itemCount++, filled);
    addButtons(this);
  },
};

function addItem(block: VariadicBlock, index: number, filled: boolean): void {
  const name = itemInput(index);
  if (block.getInput(name)) return;
  const { check, shadow } = optionsOf(block);
  const input = block.appendValueInput(name).setCheck(check);
  const operator = block.getField("OPERATOR");
  if (operator && block.getInput("A")?.type === Blockly.inputs.inputTypes.VALUE && between(block)) {
    input.appendField(new Blockly.FieldLabel(operator.getText()), `BETWEEN${index}`);
  }
  if (filled && shadow) input.connection?.setShadowState(shadowState(shadow));
}

/** Whether the operator is between the values, not before them. */
function between(block: Blockly.Block): boolean {
  return block.type === "logic_operation";
}

function addButtons(block: VariadicBlock): void {
  const input = block.appendDummyInput("BUTTONS");
  if (block.itemCount > optionsOf(block).min) {
    input.appendField(buttonField("minus", blockText("MINUS"), () => block.minus()));
  }
  input.appendField(buttonField("plus", blockText("PLUS"), () => block.plus()));
}

function helper(this: Blockly.Block): void {
  const block = this as VariadicBlock;
  const { start } = optionsOf(block);
  block.shape(start, false);
  if (!between(block)) return;
  const operator = block.getField("OPERATOR");
  operator?.setValidator((value: string) => {
    for (const field of block.getFields()) {
      if (field.name?.startsWith("BETWEEN"))
        field.setValue(blockText(value === "and" ? "AND" : "OR"));
    }
    return undefined;
  });
}

export const variadic = [mixin, helper] as const;
