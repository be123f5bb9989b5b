import type { Merged, PendingWork } from "../../api/model";
import type { Texts } from "../../i18n";

type Say = Pick<
  Texts["exchange"],
  | "groups"
  | "programs"
  | "versions"
  | "runs"
  | "brought"
  | "only"
  | "nothingNew"
  | "nothingComes"
  | "cameNameless"
  | "deleted"
  | "deletedRest"
  | "heldBack"
  | "heldBackRest"
  | "kept"
>;
type Outcome = Pick<
  Merged,
  "computer" | "name" | "added" | "anonymous" | "held_back" | "kept" | "nothing_new" | "removed"
>;

/** Summary of one merge: rows added, rows already deleted here, rows deleted now. */
export function outcome(merged: Outcome, say: Say): string {
  const { removed, held_back: heldBack } = merged;
  const sentences = [
    removed && told(counted({ ...removed, versions: 0 }, say), say.deleted, say.deletedRest),
    merged.kept.length > 0 && say.kept(merged.kept.join(", ")),
    ...came(merged, say),
    heldBack && told(counted(heldBack, say), say.heldBack, say.heldBackRest),
  ];
  return sentences.filter(Boolean).join(" ");
}

/** The non-zero counts, as text. */
export function counted(numbers: Partial<Merged["added"]>, say: Say): string {
  const { groups = 0, programs = 0, versions = 0, runs = 0 } = numbers;
  return [
    groups > 0 && say.groups(groups),
    programs > 0 && say.programs(programs),
    versions > 0 && say.versions(versions),
    runs > 0 && say.runs(runs),
  ]
    .filter(Boolean)
    .join(", ");
}

function came(merged: Outcome, say: Say): string[] {
  const { computer, name, added, anonymous } = merged;
  const who = computer ?? name;
  const parts = counted(added, say);
  if (parts) {
    return [say.brought(who, parts), ...(anonymous && added.groups > 0 ? [say.cameNameless] : [])];
  }
  if (merged.removed || merged.kept.length > 0) return [];
  // rows deleted here were not added, so "nothing new" would be wrong
  if (merged.nothing_new) return [(merged.held_back ? say.nothingComes : say.nothingNew)(who)];
  return [say.only(who)];
}

/** The text with counts, or `rest` if there are none. */
function told(parts: string, say: (parts: string) => string, rest: string): string {
  return parts ? say(parts) : rest;
}

/** Where a group is now, and what of it was unknown to the PC that deleted it; "" for nothing. */
export function newsOf(
  work: PendingWork,
  say: Pick<Texts["exchange"], "isNow" | "isNowWithout" | "isNew" | "programs" | "edits" | "runs">,
): string {
  const { is_moved, place, n_new_programs, n_new_edits, n_new_runs } = work;
  const news = [
    n_new_programs > 0 && say.programs(n_new_programs),
    n_new_edits > 0 && say.edits(n_new_edits),
    n_new_runs > 0 && say.runs(n_new_runs),
  ].filter(Boolean);
  return [
    is_moved && (place ? say.isNow(place) : say.isNowWithout),
    news.length > 0 && say.isNew(news.join(", ")),
  ]
    .filter(Boolean)
    .join(" ");
}
