import type { Branch, Command } from "../generator/document";

/** Distance of the first block from the corner of the workspace, in pixels. */
export const MARGIN = 32;
const ROW = 54;
const NESTED_VALUE = 10;
const EMPTY_STATEMENT_INPUT = 28;
const STATEMENT_INPUT_END = 36;
const GAP = 72;

/** Estimates the top of the next stack, in pixels; its exact place depends on fonts. */
export function below(top: number, commands: readonly Command[]): number {
  return top + ROW + Math.max(heightOf(commands), ROW) + GAP;
}

function heightOf(commands: readonly Command[]): number {
  return commands.reduce((height, command) => height + commandHeight(command), 0);
}

function commandHeight(command: Command): number {
  const { commands, elif, else: last, ...values } = command;
  const bodies = bodiesOf(command);
  const rows = Math.max(bodies.length, 1) * (ROW + NESTED_VALUE * depthOf(values));
  return bodies.reduce(
    (height, body) =>
      height + Math.max(heightOf(body), EMPTY_STATEMENT_INPUT) + STATEMENT_INPUT_END,
    rows,
  );
}

/** Nesting depth of the blocks in the values of a command. */
function depthOf(value: unknown): number {
  if (typeof value !== "object" || value === null) return 0;
  const inside = Math.max(0, ...Object.values(value).map(depthOf));
  return Array.isArray(value) ? inside : 1 + inside;
}

function bodiesOf(command: Command): Command[][] {
  const branches = (command.elif ?? []) as Branch[];
  const last = command.else as Command[] | undefined;
  const bodies = [
    command.commands as Command[] | undefined,
    ...branches.map(({ commands }) => commands),
    last?.length ? last : undefined,
  ];
  return bodies.filter((body) => body !== undefined);
}
