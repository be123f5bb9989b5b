import type { BlocksViewer } from "../editor/reader/viewer";
import type { Texts } from "../i18n";
import { labelled } from "../i18n/phrases";
import { commentText, type Differing, hiddenChange } from "./differences";

/** Describes a difference with the blocks' texts, such as "andar para frente 1 m → andar para frente 2 m". */
export function differenceText(
  one: Differing,
  before: BlocksViewer,
  after: BlocksViewer,
  texts: Texts,
): string {
  const { archive } = texts;
  const was = before.textOf(one.block) || archive.blockAlone;
  const is = after.textOf(one.block) || archive.blockAlone;
  if (one.kinds.includes("removed")) return was;
  if (!one.kinds.includes("changed")) return is;
  if (was !== is) return archive.became({ before: was, after: is });
  const comment = hiddenChange(one.what);
  if (!comment) return is;
  const [first, then] = [comment.before, comment.after].map(
    (stored) => commentText(stored) || archive.nothing,
  );
  return `${is} (${labelled(archive.comment, archive.became({ before: first ?? "", after: then ?? "" }))})`;
}
