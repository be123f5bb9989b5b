import type { VersionDifference, VersionOfProgram, VersionSummary } from "../api/model";
import type { Difference } from "../editor/reader/difference_badge";

type Change = VersionDifference["changed"][number]["what"][number];

/** The blocks of two versions and their difference. */
export interface ComparedWorkspaces {
  readonly before: { readonly workspace: object };
  readonly after: { readonly workspace: object };
  readonly difference: VersionDifference;
}

/** Two versions and their difference. */
export interface Compared extends ComparedWorkspaces {
  line: readonly VersionSummary[];
  before: VersionOfProgram;
  after: VersionOfProgram;
  difference: VersionDifference;
}

/** A block that differs, with all kinds of its difference. */
export interface Differing {
  readonly block: string;
  readonly kinds: readonly Difference[];
  readonly what: readonly Change[];
}

/** Each differing block once. The server lists a block that was changed and moved in two lists. */
export function differing({ added, removed, changed, moved }: VersionDifference): Differing[] {
  const movedBlocks = new Set(moved.map(({ block }) => block));
  const alsoChanged = new Set(changed.map(({ block }) => block));
  const only = (kind: Difference, blocks: readonly { block: string }[]) =>
    blocks.map(({ block }): Differing => ({ block, kinds: [kind], what: [] }));
  return [
    ...only("removed", removed),
    ...only("added", added),
    ...changed.map(
      ({ block, what }): Differing => ({
        block,
        kinds: movedBlocks.has(block) ? ["changed", "moved"] : ["changed"],
        what,
      }),
    ),
    ...only(
      "moved",
      moved.filter(({ block }) => !alsoChanged.has(block)),
    ),
  ];
}

/** The kinds to mark on the blocks of one of the two versions. */
export function kindsOf(
  difference: VersionDifference,
  side: "before" | "after",
): [string, readonly Difference[]][] {
  const otherSideKind: Difference = side === "before" ? "added" : "removed";
  return differing(difference)
    .filter(({ kinds }) => !kinds.includes(otherSideKind))
    .map(({ block, kinds }) => [block, kinds]);
}

/** A change that the block's text does not show, so that it needs its own text: a changed comment. */
export function hiddenChange(what: readonly Change[]): Change | null {
  return what.find(({ name }) => name === "comment") ?? null;
}

/** Text of a stored comment, which is a string or an object that contains one. */
export function commentText(stored: unknown): string {
  if (typeof stored === "string") return stored;
  const { text } = (stored ?? {}) as { text?: unknown };
  return typeof text === "string" ? text : "";
}
