import type { GroupReview } from "../../../api/model";

type Reviewed = Pick<GroupReview, "group" | "entries">;

/** PCs of a group whose picture and colour a group of other PCs has too; "" if none has. */
export function computersOfLookalike(one: Reviewed, all: readonly Reviewed[]): string {
  const { id, picture, color } = one.group;
  const computers = computersOf(one);
  const isAlike = all.some(
    (other) =>
      other.group.id !== id &&
      other.group.picture === picture &&
      other.group.color === color &&
      computersOf(other) !== computers,
  );
  return isAlike ? computers : "";
}

const computersOf = ({ entries }: Reviewed) =>
  [...new Set(entries.flatMap(({ computer }) => computer ?? []))].join(", ");
