import type { Group } from "../api/model";
import { enterGroup } from "../app/entering";
import { report } from "../app/session";
import { TEST } from "../app/testids";
import { texts } from "../i18n";
import { GroupPicture } from "./GroupPicture";
import { groupCounts } from "./group_counts";

/** A group by its drawing, its colour and its name. */
export function GroupCard({ group }: { group: Group }) {
  const { start } = texts.value;
  return (
    <button
      type="button"
      class="group-card card tinted"
      style={{ "--group": group.color }}
      data-testid={TEST.groupCard}
      data-picture={group.picture}
      title={start.open(group.name)}
      onClick={() => void enterGroup(group).catch(report)}
    >
      <span class="group-card__picture">
        <span class="badge badge--large">
          <GroupPicture name={group.picture} />
        </span>
      </span>
      <span class="group-card__words">
        <span class="group-card__name" dir="auto">
          {group.name}
        </span>{" "}
        <span class="group-card__counts">{groupCounts(group, texts.value)}</span>
      </span>
    </button>
  );
}
