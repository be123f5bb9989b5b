import type * as Blockly from "blockly/core";

/** A field that holds the name of a variable; implemented by `fields/name_field.ts`. */
export interface VariableField extends Blockly.Field {
  readonly holdsVariable: true;
  name_(): string;
}

/**
 * Letters of any script, digits and underscores, with spaces between; the server's reader has the
 * same rule.
 */
const NAME = /^[\p{L}\p{M}\p{N}_](?:[\p{L}\p{M}\p{N}_ ]*[\p{L}\p{M}\p{N}_])?$/u;
const MAX_LENGTH = 64;

export function isName(text: string): boolean {
  return [...text].length <= MAX_LENGTH && NAME.test(text);
}

/** The name, or the name with the lowest number that makes it unique. */
export function freeName(base: string, used: ReadonlySet<string>): string {
  let name = base;
  for (let number = 2; used.has(name); number++) name = `${base} ${number}`;
  return name;
}

/** All function definitions, in the order of their creation. */
export function definitionsIn(workspace: Blockly.Workspace): Blockly.Block[] {
  return workspace.getTopBlocks(false).filter(({ type }) => type === "function_def");
}

export function functionName(definition: Blockly.Block): string {
  return String(definition.getFieldValue("NAME"));
}

/** The parameters of a function, from its definition. */
export function parametersOf(definition: Blockly.Block): string[] {
  return (definition as Blockly.Block & { parameters(): string[] }).parameters();
}

/** Whether a function returns a value anywhere. */
export function givesValue(definition: Blockly.Block): boolean {
  return definition.getDescendants(false).some(({ type }) => type === "return_value");
}

/** The function around a block, if it has a parameter of that name. */
function scopeOf(block: Blockly.Block, name: string): Blockly.Block | null {
  const root = block.getRootBlock();
  return root.type === "function_def" && parametersOf(root).includes(name) ? root : null;
}

/**
 * Names that a block can use: variables of the program, and parameters of the function around it.
 */
export function namesFor(block: Blockly.Block): string[] {
  const root = block.getRootBlock();
  const own = root.type === "function_def" ? parametersOf(root) : [];
  return sorted(new Set([...own, ...variableNames(block.workspace)]));
}

/** Names of the variables in use, without parameters of functions. */
export function variableNames(workspace: Blockly.Workspace): string[] {
  const names = new Set<string>();
  for (const field of nameFields(workspace)) {
    const block = field.getSourceBlock();
    if (block && !scopeOf(block, field.name_())) names.add(field.name_());
  }
  return sorted(names);
}

/** Renames a variable, or a parameter within its function, everywhere. */
export function renameVariable(block: Blockly.Block, from: string, to: string): void {
  const scope = scopeOf(block, from);
  const fields = nameFields(block.workspace).filter((field) => {
    const source = field.getSourceBlock();
    return field.name_() === from && source && scopeOf(source, from) === scope;
  });
  for (const field of fields) field.setValue(to);
  const parameter = scope && parametersOf(scope).indexOf(from);
  if (scope && parameter !== null) scope.setFieldValue(to, `PARAM${parameter}`);
}

/** Renames the uses of a parameter inside its function. */
export function renameInside(definition: Blockly.Block, from: string, to: string): void {
  for (const block of definition.getDescendants(false)) {
    for (const field of fieldsOf(block)) if (field.name_() === from) field.setValue(to);
  }
}

function nameFields(workspace: Blockly.Workspace): VariableField[] {
  return workspace.getAllBlocks(false).flatMap(fieldsOf);
}

function fieldsOf(block: Blockly.Block): VariableField[] {
  if (block.isInsertionMarker()) return [];
  return [...block.getFields()].filter((field): field is VariableField => "holdsVariable" in field);
}

function sorted(names: ReadonlySet<string>): string[] {
  return [...names].sort((one, other) => one.localeCompare(other, undefined, { numeric: true }));
}
