import { MOTIONS } from "../api/declared";

/** Parts of a program that did nothing in a run. */
export interface IdleParts {
  readonly emptyLoops: number;
  /** Number of blocks that belong neither to the stack of the start block nor to a function. */
  readonly looseBlocks: number;
  /** Whether any command moves the robot. */
  readonly hasMotion: boolean;
}

/** A program as it was stored: the document that ran and its blocks. */
export interface StoredProgram {
  readonly document: unknown;
  readonly workspace: unknown;
}

const LOOPS = new Set(["repeat", "while", "until", "for", "forever"]);
const MOVING: ReadonlySet<string> = new Set(MOTIONS);
const ROOTS = new Set(["program_start", "function_def"]);

export function idleParts({ document, workspace }: StoredProgram): IdleParts {
  const commands = nodesOf(document).filter((node) => typeof node.action === "string");
  return {
    emptyLoops: commands.filter(({ action, commands: inside }) => {
      return LOOPS.has(String(action)) && (!Array.isArray(inside) || inside.length === 0);
    }).length,
    looseBlocks: looseStacks(workspace).flatMap(blocksOf).length,
    hasMotion: commands.some(({ action }) => MOVING.has(String(action))),
  };
}

type Node = Readonly<Record<string, unknown>>;

/** Every object in a JSON value. */
function nodesOf(value: unknown): Node[] {
  if (typeof value !== "object" || value === null) return [];
  const inside = Object.values(value).flatMap(nodesOf);
  return Array.isArray(value) ? inside : [value as Node, ...inside];
}

function looseStacks(workspace: unknown): Node[] {
  const { blocks } = (workspace ?? {}) as { blocks?: { blocks?: Node[] } };
  return (blocks?.blocks ?? []).filter(({ type }) => !ROOTS.has(String(type)));
}

/** A stored block with all blocks below and inside it, without shadow blocks. */
function blocksOf(block: Node): Node[] {
  const inputs = Object.values((block.inputs ?? {}) as Record<string, { block?: Node }>);
  const others = [...inputs, (block.next ?? {}) as { block?: Node }];
  return [block, ...others.flatMap((one) => (one.block ? blocksOf(one.block) : []))];
}
