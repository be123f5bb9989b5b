import { Pencil, Sticker } from "lucide-preact";
import { useState } from "preact/hooks";
import type { Group } from "../api/model";
import { texts } from "../i18n";
import { Button } from "../kit/Button";
import { LinkButton } from "../kit/LinkButton";
import { GroupPicture } from "../kit/pictures/GroupPicture";
import { liveryOf } from "../scene/livery/livery";
import { RobotPicture } from "../scene/livery/RobotPicture";
import { hashOf } from "../shell/route";
import { GroupForm } from "./GroupForm";

/** The group's name, picture and robot, with a button to edit them and a link to its album. */
export function GroupHead({ group }: { group: Group }) {
  const [editing, setEditing] = useState(false);
  if (editing) return <GroupForm group={group} onDone={() => setEditing(false)} />;
  return (
    <div class="group-head tinted row middle gap-3" style={{ "--group": group.color }}>
      <span class="badge group-head__badge">
        <GroupPicture name={group.picture} />
      </span>
      <span class="group-head__name one-line shrinks" dir="auto" data-shortened title={group.name}>
        {group.name}
      </span>
      <RobotPicture livery={liveryOf(group)} class="group-head__robot rigid" />
      {group.robot_name && (
        <span class="group-head__robot-name one-line shrinks" dir="auto" title={group.robot_name}>
          {group.robot_name}
        </span>
      )}
      <Button
        kind="plain"
        icon={Pencil}
        label={texts.value.classes.change}
        testId="group-edit"
        onPress={() => setEditing(true)}
      />
      {group.has_album && (
        <LinkButton
          class="rigid"
          icon={Sticker}
          href={hashOf({ screen: "album", group: group.id })}
          testId="work-album"
        >
          {texts.value.titles.album}
        </LinkButton>
      )}
    </div>
  );
}
