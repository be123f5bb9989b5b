import type * as Blockly from "blockly/core";
import { changeShape } from "./change_shape";
import { shadowState } from "./shadows";

/** The called function, and the names of its parameters in their order. */
export interface CallState {
  name: string;
  parameters?: readonly string[];
}

interface CallBlock extends Blockly.Block {
  called: string;
  names: readonly string[];
  follow(name: string, parameters: readonly string[]): void;
  shape(name: string, parameters: readonly string[], filled: boolean): void;
}

const mixin = {
  called: "",
  names: [] as readonly string[],

  saveExtraState(this: CallBlock): CallState {
    return { name: this.called, ...(this.names.length > 0 && { parameters: [...this.names] }) };
  },

  loadExtraState(this: CallBlock, state: Partial<CallState>): void {
    const inUse = this.inputList.some((input) => input.connection?.isConnected());
    this.shape(state.name ?? "", state.parameters ?? [], inUse);
  },

  /**
   * Updates the call to its definition. A value follows the name of its parameter; if a parameter
   * was renamed, values keep their positions.
   */
  follow(this: CallBlock, name: string, parameters: readonly string[]): void {
    changeShape(this, () => this.shape(name, parameters, true));
  },

  shape(this: CallBlock, name: string, parameters: readonly string[], filled: boolean): void {
    const children = detachChildren(this, parameters);
    for (let index = this.names.length; index-- > 0; ) this.removeInput(`ARG${index}`);
    this.called = name;
    this.names = [...parameters];
    this.setFieldValue(name, "NAME");
    parameters.forEach((parameter, index) => {
      addArgument(this, parameter, index, children.get(index), filled);
    });
  },
};

interface Child {
  block: Blockly.Block | null;
  shadow: Blockly.serialization.blocks.State | null;
}

/** Unplugs the values of the inputs; returns them by their new position. */
function detachChildren(block: CallBlock, parameters: readonly string[]): Map<number, Child> {
  const sameNames = block.names.every((name) => parameters.includes(name));
  const renamed = parameters.length === block.names.length && !sameNames;
  const children = new Map<number, Child>();
  block.names.forEach((name, place) => {
    const connection = block.getInput(`ARG${place}`)?.connection;
    const index = renamed ? place : parameters.indexOf(name);
    if (!connection || index < 0) return;
    const target = connection.targetBlock();
    const real = target && !target.isShadow() ? target : null;
    children.set(index, { block: real, shadow: connection.getShadowState(true) });
    real?.unplug();
  });
  return children;
}

function addArgument(
  block: CallBlock,
  parameter: string,
  index: number,
  child: Child | undefined,
  filled: boolean,
): void {
  const input = block.appendValueInput(`ARG${index}`).appendField(`${parameter}:`);
  const shadow = child?.shadow ?? (filled ? shadowState({ number: 0 }) : null);
  if (shadow) input.connection?.setShadowState(shadow);
  if (child?.block?.outputConnection) input.connection?.connect(child.block.outputConnection);
}

export function callOf(block: Blockly.Block): Required<CallState> {
  const { called, names } = block as CallBlock;
  return { name: called, parameters: names };
}

export function followDefinition(
  call: Blockly.Block,
  name: string,
  parameters: readonly string[],
): void {
  (call as CallBlock).follow(name, parameters);
}

export const callShape = [mixin] as const;
