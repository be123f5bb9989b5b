import type { Level } from "../definition";
import { ALL_DEFINITIONS } from "../definitions";

interface StoredBlock {
  readonly type?: string;
}

const LEVEL_OF = new Map<string, Level>(ALL_DEFINITIONS.map(({ type, level }) => [type, level]));

/**
 * The lowest level that offers every block of a stored workspace. Shadow blocks do not count:
 * blocks of every level have them.
 */
export function levelNeeded(workspace: unknown): Level {
  let highest: Level = 1;
  const visit = (node: unknown, key: string) => {
    if (typeof node !== "object" || node === null || key === "shadow") return;
    const found = LEVEL_OF.get((node as StoredBlock).type ?? "") ?? 1;
    if (found > highest) highest = found;
    for (const [name, part] of Object.entries(node)) visit(part, name);
  };
  visit(workspace, "");
  return highest;
}
