import type { VersionDifference } from "../api/keeping";
import type { Difference } from "../editor/difference_sign";

type Change = VersionDifference["changed"][number]["what"][number];

/** One block that differs, with all that became of it. */
export interface Differing {
  readonly block: string;
  readonly kinds: readonly Difference[];
  readonly what: readonly Change[];
}

/** Every block that differs once, although the server tells one that was changed and moved in both lists. */
export function differing({ added, removed, changed, moved }: VersionDifference): Differing[] {
  const apart = new Set(moved.map(({ block }) => block));
  const alsoChanged = new Set(changed.map(({ block }) => block));
  const only = (kind: Difference, blocks: readonly { block: string }[]) =>
    blocks.map(({ block }): Differing => ({ block, kinds: [kind], what: [] }));
  return [
    ...only("removed", removed),
    ...only("added", added),
    ...changed.map(
      ({ block, what }): Differing => ({
        block,
        kinds: apart.has(block) ? ["changed", "moved"] : ["changed"],
        what,
      }),
    ),
    ...only(
      "moved",
      moved.filter(({ block }) => !alsoChanged.has(block)),
    ),
  ];
}

/** What is marked on the blocks of one of the two versions. */
export function kindsOf(
  difference: VersionDifference,
  side: "before" | "after",
): [string, readonly Difference[]][] {
  const elsewhere: Difference = side === "before" ? "added" : "removed";
  return differing(difference)
    .filter(({ kinds }) => !kinds.includes(elsewhere))
    .map(({ block, kinds }) => [block, kinds]);
}

/** A change that the words of the block do not show, told by itself: the text of a comment, mostly. */
export function hiddenChange(what: readonly Change[]): Change | null {
  return what.find(({ name }) => name === "comment") ?? null;
}

/** A comment as it is kept is a text, or an object that holds one. */
export function commentText(kept: unknown): string {
  if (typeof kept === "string") return kept;
  const { text } = (kept ?? {}) as { text?: unknown };
  return typeof text === "string" ? text : "";
}
