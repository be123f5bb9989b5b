import type { GroupReview } from "../../../api/model";

type Reviewed = Pick<GroupReview, "group" | "entries">;

/** PCs of a group whose picture and colour another group of the lesson has too; "" if none has. */
export function computersOfLookalike(one: Reviewed, all: readonly Reviewed[]): string {
  const { id, picture, color } = one.group;
  const isAlike = all.some(
    ({ group }) => group.id !== id && group.picture === picture && group.color === color,
  );
  const names = one.entries.flatMap(({ computer }) => computer ?? []);
  return isAlike ? [...new Set(names)].join(", ") : "";
}
