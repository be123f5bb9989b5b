import { GroupPicture } from "../kit/pictures/GroupPicture";
import type { ShownGroup } from "./names";

/** Picture and name of a group, or its letter. */
export function PresentedGroup({ group }: { group: ShownGroup }) {
  return (
    <p
      class="presentation__group row middle gap-3 tinted shrinks"
      style={group.colour ? { "--group": group.colour } : {}}
      data-testid="presentation-group"
    >
      {group.picture !== null && (
        <span class="badge presentation__badge">
          <GroupPicture name={group.picture} />
        </span>
      )}
      <span class="presentation__name one-line" dir="auto">
        {group.name}
      </span>
    </p>
  );
}
