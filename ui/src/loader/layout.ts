import type { Branch, Command } from "../generator/document";

/** From the corner of the workspace, in pixels; see the editor's margin. */
export const MARGIN = 32;
const ROW = 56;
const END_OF_MOUTH = 40;
const GAP = 64;
const INDENT = 16;
const WIDEST_ROW = 560;

/** How high a stack of blocks is drawn, about: a document knows nothing of fonts. */
export function heightOf(commands: readonly Command[]): number {
  return commands.reduce((height, command) => height + commandHeight(command), 0);
}

/** How far a stack reaches to the right, about. */
export function widthOf(commands: readonly Command[]): number {
  return WIDEST_ROW + INDENT * depthOf(commands);
}

/** Where the next stack begins below one of that height. */
export function below(top: number, commands: readonly Command[]): number {
  return top + ROW + heightOf(commands) + GAP;
}

function commandHeight(command: Command): number {
  return bodiesOf(command).reduce(
    (height, body) => height + Math.max(heightOf(body), ROW / 2) + END_OF_MOUTH,
    ROW,
  );
}

function depthOf(commands: readonly Command[]): number {
  return commands.reduce(
    (depth, command) => Math.max(depth, ...bodiesOf(command).map((body) => 1 + depthOf(body))),
    0,
  );
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
