import * as Blockly from "blockly/core";
import type { BlockArgument, Level } from "../definition";
import { argumentsOf, type Row } from "../definitions";
import { definitionsIn, functionName, givesValue } from "../names";
import type { TextKey } from "../words";
import { word, wordsToFind } from "../words";
import { block, callBlock, type Offered, offeredRows } from "./toolbox";

type ToolboxBlock = Blockly.utils.toolbox.BlockInfo;

/**
 * The blocks of a level that say all of the words, or beginnings of them, in the language of the page: first those
 * that have them on the block or are called so by pupils, then those that say them in their help. Accents and capitals
 * do not matter.
 */
export function searchBlocks(
  query: string,
  level: Level,
  workspace: Blockly.Workspace,
  offered: Offered = null,
): ToolboxBlock[] {
  const wanted = wordsOf(query);
  if (wanted.length === 0) return [];
  const found = offeredRows(level, offered)
    .filter(({ type }) => type !== "call" && type !== "call_value")
    .map((row) => ({ row, rank: rank(row, wanted) }))
    .filter(({ rank }) => rank > 0)
    .sort((one, other) => other.rank - one.rank);
  return [...found.map(({ row }) => block(row.type)), ...calls(wanted, workspace)];
}

function calls(wanted: readonly string[], workspace: Blockly.Workspace): ToolboxBlock[] {
  return definitionsIn(workspace)
    .filter((definition) => saysAll(functionName(definition), wanted))
    .flatMap((definition) => [
      callBlock("call", definition),
      ...(givesValue(definition) ? [callBlock("call_value", definition)] : []),
    ]);
}

function rank(row: Row, wanted: readonly string[]): number {
  const key = row.type.toUpperCase();
  const label = [word(key as TextKey), ...choicesOf(row)].join(" ").replace(/%\d/g, " ");
  const onBlock = `${label} ${wordsToFind(row.type)}`;
  const said = new Set(wordsOf(onBlock));
  if (wanted.every((one) => said.has(one))) return 3;
  if (saysAll(onBlock, wanted)) return 2;
  const category = word(`CATEGORY_${row.style.toUpperCase()}` as TextKey);
  const help = word(`${key}_TIP` as TextKey);
  return saysAll(`${onBlock} ${category} ${help}`, wanted) ? 1 : 0;
}

/** The words a dropdown of the block offers. */
function choicesOf(row: Row): string[] {
  return (argumentsOf(row) as readonly BlockArgument[]).flatMap(({ options }) =>
    ((options ?? []) as [string, string][]).map(([label]) =>
      Blockly.utils.parsing.replaceMessageReferences(label),
    ),
  );
}

/** Whether a text has all of the words, or beginnings of them. */
export function saysAll(text: string, wanted: readonly string[]): boolean {
  const said = wordsOf(text);
  return wanted.every((one) => said.some((other) => other.startsWith(one)));
}

/** The words of a text, without accents and capitals. */
export function wordsOf(text: string): string[] {
  return folded(text)
    .split(/[^\p{L}\p{N}+−×÷=≠<>≤≥^]+/u)
    .filter(Boolean);
}

function folded(text: string): string {
  return text.normalize("NFD").replace(/\p{M}/gu, "").toLowerCase();
}
