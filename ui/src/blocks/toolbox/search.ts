import * as Blockly from "blockly/core";
import type { BlockArgument, Level } from "../definition";
import { argumentsOf, type Row } from "../definitions";
import { definitionsIn, functionName, givesValue } from "../names";
import type { TextKey } from "../texts";
import { blockText, searchTerms } from "../texts";
import { block, callBlock, type OfferedActions, offeredRows } from "./toolbox";

type ToolboxBlock = Blockly.utils.toolbox.BlockInfo;

/**
 * The blocks of a level that match all words of the query, or prefixes of them, in the current
 * language. Matches in the block's text, choices and search terms come first, then matches in its
 * category and help. Accents and capitals do not matter.
 */
export function searchBlocks(
  query: string,
  level: Level,
  workspace: Blockly.Workspace,
  offered: OfferedActions = null,
): ToolboxBlock[] {
  const terms = tokenize(query);
  if (terms.length === 0) return [];
  const found = offeredRows(level, offered)
    .filter(({ type }) => type !== "call" && type !== "call_value")
    .map((row) => ({ row, rank: rank(row, terms) }))
    .filter(({ rank }) => rank > 0)
    .sort((one, other) => other.rank - one.rank);
  return [...found.map(({ row }) => block(row.type)), ...calls(terms, workspace)];
}

function calls(terms: readonly string[], workspace: Blockly.Workspace): ToolboxBlock[] {
  return definitionsIn(workspace)
    .filter((definition) => matchesAll(functionName(definition), terms))
    .flatMap((definition) => [
      callBlock("call", definition),
      ...(givesValue(definition) ? [callBlock("call_value", definition)] : []),
    ]);
}

function rank(row: Row, terms: readonly string[]): number {
  const key = row.type.toUpperCase();
  const label = [blockText(key as TextKey), ...choicesOf(row)].join(" ").replace(/%\d/g, " ");
  const onBlock = `${label} ${searchTerms(row.type)}`;
  const tokens = new Set(tokenize(onBlock));
  if (terms.every((one) => tokens.has(one))) return 3;
  if (matchesAll(onBlock, terms)) return 2;
  const category = blockText(`CATEGORY_${row.style.toUpperCase()}` as TextKey);
  const help = blockText(`${key}_TIP` as TextKey);
  return matchesAll(`${onBlock} ${category} ${help}`, terms) ? 1 : 0;
}

/** The labels of a block's dropdowns. */
function choicesOf(row: Row): string[] {
  return (argumentsOf(row) as readonly BlockArgument[]).flatMap(({ options }) =>
    ((options ?? []) as [string, string][]).map(([label]) =>
      Blockly.utils.parsing.replaceMessageReferences(label),
    ),
  );
}

/** Whether a text contains all the words, or words that begin with them. */
export function matchesAll(text: string, terms: readonly string[]): boolean {
  const tokens = tokenize(text);
  return terms.every((one) => tokens.some((other) => other.startsWith(one)));
}

/** The words of a text, without accents and capitals. */
export function tokenize(text: string): string[] {
  return folded(text)
    .split(/[^\p{L}\p{N}+−×÷=≠<>≤≥^]+/u)
    .filter(Boolean);
}

function folded(text: string): string {
  return text.normalize("NFD").replace(/\p{M}/gu, "").toLowerCase();
}
