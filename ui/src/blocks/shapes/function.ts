import type * as Blockly from "blockly/core";
import { buttonField } from "../fields/button_field";
import { DefinitionNameField } from "../fields/definition_name_field";
import { definitionsIn, freeName, functionName } from "../names";
import { blockText } from "../texts";
import { changeShape } from "./change_shape";

export interface FunctionState {
  parameters?: string[];
}

interface FunctionBlock extends Blockly.Block {
  parameters(): string[];
  plus(): void;
  minus(index: number): void;
  shape(names: readonly string[]): void;
}

/** The block that defines a function, with fields for its parameters. */
const mixin = {
  saveExtraState(this: FunctionBlock): FunctionState | null {
    const parameters = this.parameters();
    return parameters.length === 0 ? null : { parameters };
  },

  loadExtraState(this: FunctionBlock, state: FunctionState): void {
    this.shape(state.parameters ?? []);
  },

  parameters(this: FunctionBlock): string[] {
    const names: string[] = [];
    for (let index = 0; ; index++) {
      const field = this.getField(`PARAM${index}`);
      if (!field) return names;
      names.push(String(field.getValue()));
    }
  },

  plus(this: FunctionBlock): void {
    const names = this.parameters();
    const name = freeName(blockText("PARAMETER_NAME"), new Set(names));
    changeShape(this, () => this.shape([...names, name]));
  },

  minus(this: FunctionBlock, index: number): void {
    changeShape(this, () => this.shape(this.parameters().filter((_, other) => other !== index)));
  },

  shape(this: FunctionBlock, names: readonly string[]): void {
    if (this.getInput("PARAMETERS")) this.removeInput("PARAMETERS");
    const input = this.appendDummyInput("PARAMETERS");
    if (names.length > 0) input.appendField(blockText("WITH"));
    names.forEach((name, index) => {
      input.appendField(parameterField(this, index, name), `PARAM${index}`);
      input.appendField(
        buttonField("minus", blockText("MINUS_PARAMETER"), () => this.minus(index)),
      );
    });
    input.appendField(buttonField("plus", blockText("PLUS_PARAMETER"), () => this.plus()));
  },
};

/** Parameter names are saved in the block's extra state, not as fields. */
class ParameterField extends DefinitionNameField {
  override isSerializable(): boolean {
    return false;
  }
}

function parameterField(block: FunctionBlock, index: number, name: string): Blockly.Field {
  const field = new ParameterField("");
  field.isInUse = (other) =>
    block.parameters().some((parameter, place) => place !== index && parameter === other);
  field.load(name);
  return field as unknown as Blockly.Field;
}

function helper(this: Blockly.Block): void {
  const block = this as FunctionBlock;
  const name = block.getField("NAME");
  if (name instanceof DefinitionNameField) {
    name.isInUse = (other) =>
      definitionsIn(block.workspace).some(
        (definition) => definition !== block && functionName(definition) === other,
      );
  }
  block.shape([]);
}

export const functionShape = [mixin, helper] as const;
