import type { Merged, PendingWork } from "../../api/model";
import type { Texts } from "../../i18n";

type OutcomeTexts = Pick<
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
type MergedCounts = Pick<
  Merged,
  "computer" | "name" | "added" | "anonymous" | "held_back" | "kept" | "nothing_new" | "removed"
>;

/** Summary of one merge: rows added, rows already deleted here, rows deleted now. */
export function outcome(merged: MergedCounts, texts: OutcomeTexts): string {
  const { removed, held_back: heldBack } = merged;
  const sentences = [
    removed &&
      textWithCounts(counted({ ...removed, versions: 0 }, texts), texts.deleted, texts.deletedRest),
    merged.kept.length > 0 && texts.kept({ names: merged.kept.join(", ") }),
    ...came(merged, texts),
    heldBack && textWithCounts(counted(heldBack, texts), texts.heldBack, texts.heldBackRest),
  ];
  return sentences.filter(Boolean).join(" ");
}

/** The non-zero counts, as text. */
export function counted(numbers: Partial<Merged["added"]>, texts: OutcomeTexts): string {
  const { groups = 0, programs = 0, versions = 0, runs = 0 } = numbers;
  return [
    groups > 0 && texts.groups({ count: groups }),
    programs > 0 && texts.programs({ count: programs }),
    versions > 0 && texts.versions({ count: versions }),
    runs > 0 && texts.runs({ count: runs }),
  ]
    .filter(Boolean)
    .join(", ");
}

function came(merged: MergedCounts, texts: OutcomeTexts): string[] {
  const { computer, name, added, anonymous } = merged;
  const who = computer ?? name;
  const parts = counted(added, texts);
  if (parts) {
    return [
      texts.brought({ computer: who, parts }),
      ...(anonymous && added.groups > 0 ? [texts.cameNameless] : []),
    ];
  }
  if (merged.removed || merged.kept.length > 0) return [];
  // rows deleted here were not added, so "nothing new" would be wrong
  if (merged.nothing_new)
    return [(merged.held_back ? texts.nothingComes : texts.nothingNew)({ computer: who })];
  return [texts.only({ computer: who })];
}

/** The text with counts, or `rest` if there are none. */
function textWithCounts(
  parts: string,
  format: (values: { parts: string }) => string,
  rest: string,
): string {
  return parts ? format({ parts }) : rest;
}

/** Text about a group's new place, and about work that the deleting PC did not have; "" without either. */
export function newsOf(
  work: PendingWork,
  texts: Pick<
    Texts["exchange"],
    "isNow" | "isNowWithout" | "isNew" | "programs" | "edits" | "runs"
  >,
): string {
  const { is_moved, place, n_new_programs, n_new_edits, n_new_runs } = work;
  const news = [
    n_new_programs > 0 && texts.programs({ count: n_new_programs }),
    n_new_edits > 0 && texts.edits({ count: n_new_edits }),
    n_new_runs > 0 && texts.runs({ count: n_new_runs }),
  ].filter(Boolean);
  return [
    is_moved && (place ? texts.isNow({ classroom: place }) : texts.isNowWithout),
    news.length > 0 && texts.isNew({ parts: news.join(", ") }),
  ]
    .filter(Boolean)
    .join(" ");
}
