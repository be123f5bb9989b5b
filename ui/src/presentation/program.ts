import { api } from "../api/client";
import type { Group } from "../api/model";

/** A program without a run. */
export interface ProgramToPresent {
  readonly name: string;
  readonly groupId: string;
  readonly groups: readonly Group[];
  /** The blocks; null before the first version. */
  readonly workspace: object | null;
  /** Ids of the blocks, in the order in which the program runs them first. */
  readonly blocks: readonly string[];
}

export async function loadProgram(id: string): Promise<ProgramToPresent> {
  const [{ name, group_id, version }, groups] = await Promise.all([api.program(id), api.groups()]);
  return {
    name,
    groupId: group_id,
    groups,
    workspace: version?.workspace ?? null,
    blocks: blocksOf(version?.document),
  };
}

/** The ids of the blocks in a program document; none if its blocks have faults. */
export function blocksOf(document: unknown): string[] {
  if (Array.isArray(document)) return document.flatMap(blocksOf);
  if (typeof document !== "object" || document === null) return [];
  const own = "action" in document && "block" in document ? document.block : null;
  const inner = Object.values(document).flatMap(blocksOf);
  return typeof own === "string" ? [own, ...inner] : inner;
}
