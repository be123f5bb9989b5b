import * as Blockly from "blockly/core";
import { definitionsIn, freeName, functionName, parametersOf, renameInside } from "../names";
import { callOf, followDefinition } from "./call";

/**
 * Updates calls when their definition changes, and gives a copied definition a unique name. Both
 * belong to the undo step of the change that caused them.
 */
export function syncCalls(workspace: Blockly.Workspace): void {
  workspace.addChangeListener((event) => {
    if (!event.recordUndo || event.isUiEvent) return;
    if (isCreate(event)) inGroup(event, () => renameDuplicates(workspace, event.ids ?? []));
    if (isChange(event)) inGroup(event, () => follow(workspace, event));
  });
}

function follow(workspace: Blockly.Workspace, event: Blockly.Events.BlockChange): void {
  const definition = workspace.getBlockById(event.blockId ?? "");
  if (definition?.type !== "function_def") return;
  const name = functionName(definition);
  const field = event.element === "field" ? (event.name ?? "") : "";
  if (field.startsWith("PARAM")) {
    renameInside(definition, String(event.oldValue), String(event.newValue));
  }
  const before = field === "NAME" ? String(event.oldValue) : name;
  updateCalls(workspace, before, name, parametersOf(definition));
}

function updateCalls(
  workspace: Blockly.Workspace,
  before: string,
  name: string,
  parameters: readonly string[],
): void {
  for (const type of ["call", "call_value"]) {
    for (const call of workspace.getBlocksByType(type, false)) {
      if (callOf(call).name === before) followDefinition(call, name, parameters);
    }
  }
}

function renameDuplicates(workspace: Blockly.Workspace, ids: readonly string[]): void {
  for (const definition of definitionsIn(workspace)) {
    if (!ids.includes(definition.id)) continue;
    const others = definitionsIn(workspace).filter((other) => other !== definition);
    const name = functionName(definition);
    const free = freeName(name, new Set(others.map(functionName)));
    if (free !== name) definition.setFieldValue(free, "NAME");
  }
}

function inGroup(event: Blockly.Events.Abstract, act: () => void): void {
  const before = Blockly.Events.getGroup();
  Blockly.Events.setGroup(event.group);
  try {
    act();
  } finally {
    Blockly.Events.setGroup(before);
  }
}

function isCreate(event: Blockly.Events.Abstract): event is Blockly.Events.BlockCreate {
  return event.type === Blockly.Events.BLOCK_CREATE;
}

function isChange(event: Blockly.Events.Abstract): event is Blockly.Events.BlockChange {
  return event.type === Blockly.Events.BLOCK_CHANGE;
}
