import type { Group } from "../api/model";
import { texts } from "../i18n";
import { Button } from "../kit/Button";
import { GroupPicture } from "../kit/pictures/GroupPicture";
import { liveryOf } from "../scene/livery/livery";
import { RobotPicture } from "../scene/livery/RobotPicture";
import { enterGroup } from "../work/entering";
import { groupCounts } from "./group_counts";

/** A group with its picture, colour and name. */
export function GroupCard({ group }: { group: Group }) {
  const { start } = texts.value;
  return (
    <Button
      kind="bare"
      class="group-card card tinted column"
      style={{ "--group": group.color }}
      testId="group-card"
      data-picture={group.picture}
      tip={start.open({ name: group.name })}
      onPress={() => enterGroup(group)}
    >
      <span class="group-card__picture">
        <span class="badge badge--large">
          <GroupPicture name={group.picture} />
        </span>
        <RobotPicture livery={liveryOf(group)} class="group-card__robot" />
      </span>
      <span class="group-card__words">
        <span class="group-card__name one-line" dir="auto">
          {group.name}
        </span>{" "}
        <span class="group-card__counts">{groupCounts(group, texts.value)}</span>
      </span>
    </Button>
  );
}
