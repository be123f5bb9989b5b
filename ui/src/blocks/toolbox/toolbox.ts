import type * as Blockly from "blockly/core";
import type { BlockArgument, Level } from "../definition";
import {
  argumentsOf,
  type BlockType,
  CATEGORIES,
  DEFINITIONS,
  definitionOf,
  type Row,
} from "../definitions";
import type { Category } from "../hues";
import {
  definitionsIn,
  freeName,
  functionName,
  givesValue,
  parametersOf,
  variableNames,
} from "../names";
import { shadowState } from "../shapes/shadows";
import { itemInput } from "../shapes/variadic";
import type { TextKey } from "../texts";
import { blockText, reference } from "../texts";

type ToolboxBlock = Blockly.utils.toolbox.BlockInfo;
type Inputs = NonNullable<ToolboxBlock["inputs"]>;
type ToolboxCategory = Exclude<Category, "start">;

export const EVERYTHING: Level = 3;

/** The actions that an activity offers; null for all blocks of the level. */
export type OfferedActions = readonly string[] | null;

/**
 * Commands with a condition. An activity without these offers no value blocks of the first level.
 */
const WITH_CONDITION = ["conditional_execution", "while", "until", "wait_until"];

/** Gap between blocks of the toolbox, in pixels. */
const GAP = 16;

/** The categories of the toolbox. It omits the start block, which every workspace already has. */
export const TOOLBOX_CATEGORIES = CATEGORIES.filter(
  (category): category is ToolboxCategory => category !== "start",
);

/** Kind of the toolbox item that holds the search field. */
export const SEARCH_KIND = "pinel_search";

/** The toolbox: the search, and each category with blocks of the level or of the activity. */
export function toolbox(
  level: Level = EVERYTHING,
  offered: OfferedActions = null,
): Blockly.utils.toolbox.ToolboxInfo {
  const categories = TOOLBOX_CATEGORIES.filter((name) => rowsOf(name, level, offered).length > 0);
  const search = {
    kind: SEARCH_KIND,
    id: "search",
    name: reference("SEARCH"),
    contents: [],
    level,
    offered,
  };
  return {
    kind: "categoryToolbox",
    contents: [
      search as unknown as Blockly.utils.toolbox.StaticCategoryInfo,
      ...categories.map((name) => category(name, level)),
    ],
  };
}

/** The blocks of a category's flyout, for a program. */
export function flyoutBlocks(
  name: ToolboxCategory,
  level: Level,
  workspace: Blockly.Workspace,
  offered: OfferedActions = null,
): ToolboxBlock[] {
  const rows = rowsOf(name, level, offered);
  if (name === "variables") return variableBlocks(rows, workspace);
  if (name === "functions") return functionBlocks(rows, workspace);
  const blocks = rows.map(({ type }) => block(type));
  const has = (type: BlockType) => rows.some((row) => row.type === type);
  if (has("compare") && level > 1) blocks.splice(2, 0, numberComparison());
  if (has("if")) blocks.splice(1, 0, { ...block("if"), extraState: { else: true } });
  return blocks;
}

/** A block as the flyout offers it, to be put into a workspace. */
export function flyoutBlock(
  type: BlockType,
  level: Level,
  workspace: Blockly.Workspace,
): Blockly.serialization.blocks.State {
  const name = definitionOf(type).style as ToolboxCategory;
  const offered = flyoutBlocks(name, level, workspace).find((one) => one.type === type);
  return (offered ?? block(type)) as Blockly.serialization.blocks.State;
}

/** All blocks on offer; the search looks through them. */
export function offeredRows(level: Level, offered: OfferedActions = null): Row[] {
  return TOOLBOX_CATEGORIES.flatMap((name) => rowsOf(name, level, offered));
}

/**
 * A block of the toolbox, with placeholders in its inputs: an empty input does not show its use.
 */
export function block(type: BlockType): ToolboxBlock {
  const row = (Object.values(DEFINITIONS) as (readonly Row[])[])
    .flat()
    .find((one) => one.type === type) as Row;
  const inputs = { ...shadows(row), ...FILLED[type]?.() };
  return { kind: "block", type, inputs, fields: FIELDS[type]?.() ?? {}, gap: GAP };
}

function rowsOf(name: ToolboxCategory, level: Level, offered: OfferedActions): Row[] {
  return (DEFINITIONS[name] as readonly Row[]).filter(
    (row) => row.hidden === undefined && (offered ? isIn(offered, row, level) : row.level <= level),
  );
}

/**
 * Whether an activity offers a block. It lists commands of any level; value blocks follow the
 * level.
 */
function isIn(offered: readonly string[], { makes, level: minLevel }: Row, level: Level): boolean {
  if (makes && "action" in makes) return offered.includes(makes.action);
  if (makes && "function" in makes) return offered.includes("call");
  const hasUse = minLevel > 1 || offered.some((action) => WITH_CONDITION.includes(action));
  return minLevel <= level && hasUse;
}

function category(
  name: ToolboxCategory,
  level: Level,
): Blockly.utils.toolbox.StaticCategoryInfo & { custom: string } {
  return {
    kind: "category",
    id: name,
    name: reference(`CATEGORY_${name.toUpperCase()}` as TextKey),
    categorystyle: name,
    custom: flyoutKey(name, level),
    contents: [],
    colour: undefined,
    cssconfig: undefined,
    hidden: undefined,
  };
}

function flyoutKey(name: ToolboxCategory, level: Level): string {
  return `pinel_${name}_${level}`;
}

/**
 * Registers callbacks that fill a category when it opens: its blocks depend on the program and on
 * the actions on offer at that time.
 */
export function registerFlyouts(
  workspace: Blockly.WorkspaceSvg,
  offered: () => OfferedActions,
): void {
  for (const level of [1, 2, 3] as const) {
    for (const name of TOOLBOX_CATEGORIES) {
      workspace.registerToolboxCategoryCallback(flyoutKey(name, level), () =>
        flyoutBlocks(name, level, workspace, offered()),
      );
    }
  }
}

function shadows(row: Row): Inputs {
  const inputs: Inputs = {};
  for (const { name, shadow } of argumentsOf(row) as readonly BlockArgument[]) {
    if (name && shadow) inputs[name] = { shadow: shadowState(shadow) };
  }
  const { start = 0, shadow } = row.variadic ?? {};
  for (let index = 0; shadow && index < start; index++) {
    inputs[itemInput(index)] = { shadow: shadowState(shadow) };
  }
  return inputs;
}

const sides = () => ({
  A: { shadow: { type: "gesture_result" } },
  B: { shadow: shadowState({ letter: "B" }) },
});

/** Shadow blocks: a condition that is put in their place leaves no loose block behind. */
const bumper = { shadow: { type: "bumper" } };

const listShadow = () => ({
  shadow: { type: "variable", fields: { NAME: blockText("LIST_NAME") } },
});

const FILLED: Partial<Record<BlockType, () => Inputs>> = {
  if: () => ({ CONDITION: { shadow: { type: "boolean", fields: { BOOL: "TRUE" } } } }),
  compare: sides,
  while: () => ({ CONDITION: { shadow: { type: "not", inputs: { A: bumper } } } }),
  until: () => ({ CONDITION: bumper }),
  wait_until: () => ({ CONDITION: bumper }),
  wait_until_timeout: () => ({ CONDITION: bumper }),
  item: () => ({ LIST: listShadow() }),
  contains: () => ({ LIST: listShadow() }),
  position_of: () => ({ LIST: listShadow() }),
  length: () => ({ A: listShadow() }),
};

const FIELDS: Partial<Record<BlockType, () => Record<string, string>>> = {
  append: () => ({ LIST: blockText("LIST_NAME") }),
  replace_item: () => ({ LIST: blockText("LIST_NAME") }),
  text: () => ({ TEXT: blockText("WORD") }),
};

function numberComparison(): ToolboxBlock {
  return {
    ...block("compare"),
    fields: { OPERATOR: "<" },
    inputs: {
      A: { shadow: shadowState({ number: 1 }) },
      B: { shadow: shadowState({ number: 2 }) },
    },
  };
}

/** Commands that use an existing variable, then one block for each variable. */
function variableBlocks(rows: readonly Row[], workspace: Blockly.Workspace): ToolboxBlock[] {
  const used = variableNames(workspace);
  const names = used.length > 0 ? used : [blockText("VARIABLE_NAME")];
  const named = (type: BlockType, NAME: string | undefined): ToolboxBlock => ({
    ...block(type),
    fields: { NAME },
  });
  return rows.flatMap(({ type }) =>
    type === "variable" ? names.map((name) => named(type, name)) : [named(type, names[0])],
  );
}

/** A definition with a unique name, the return blocks, and calls of every defined function. */
function functionBlocks(rows: readonly Row[], workspace: Blockly.Workspace): ToolboxBlock[] {
  const definitions = definitionsIn(workspace);
  const used = new Set(definitions.map(functionName));
  return rows.flatMap(({ type }) => {
    if (type === "call" || type === "call_value") return calls(type, definitions);
    if (type !== "function_def") return [block(type)];
    return [{ ...block(type), fields: { NAME: freeName(blockText("FUNCTION_NAME"), used) } }];
  });
}

/** Calls of the functions. As a value, only functions that return one. */
function calls(type: "call" | "call_value", definitions: readonly Blockly.Block[]): ToolboxBlock[] {
  return definitions
    .filter((definition) => type === "call" || givesValue(definition))
    .map((definition) => callBlock(type, definition));
}

/** A call of a function, with a number in each input. */
export function callBlock(type: "call" | "call_value", definition: Blockly.Block): ToolboxBlock {
  const parameters = parametersOf(definition);
  const inputs: Inputs = {};
  parameters.forEach((_, index) => {
    inputs[`ARG${index}`] = { shadow: shadowState({ number: 1 }) };
  });
  return {
    kind: "block",
    type,
    extraState: { name: functionName(definition), parameters },
    inputs,
    gap: GAP,
  };
}
