import { classesApi } from "../../api/classes";
import type { Group, GroupChanges } from "../../api/model";
import { language, texts } from "../../i18n";
import { GroupPicture } from "../../kit/pictures/GroupPicture";
import { useAction } from "../../kit/requests/action";
import { FaultLine } from "../../kit/requests/FaultLine";
import { Select, type SelectOption } from "../../kit/Select";
import { withDistinctNames } from "../../shell/namesakes";
import { asTeacher } from "../../shell/teacher/teacher_session";
import { groupCounts } from "../../start/group_counts";
import { NameField } from "../NameField";
import type { School } from "../school";

interface ClassGroupProps {
  group: Group;
  school: School;
  reload(): Promise<void>;
  onMoved(message: string): void;
}

/** A group in the list of its class, with controls to rename and to move it. */
export function ClassGroup({ group, school, reload, onMoved }: ClassGroupProps) {
  const { classes: labels } = texts.value.teacher;
  const { fault, act } = useAction(asTeacher);
  const others = withDistinctNames(school.classes, language.value)
    .filter((one) => one.id !== group.classroom_id)
    .map(({ id, name }): SelectOption<string> => [id, name]);
  const change = async (changes: GroupChanges) => {
    await classesApi.changeGroup(group.id, changes);
    await reload();
  };
  const move = async (id: string) => {
    await change({ classroom_id: id });
    onMoved(
      labels.moved({ group: group.name, name: others.find(([one]) => one === id)?.[1] ?? "" }),
    );
  };
  return (
    <>
      <span class="badge badge--middle tinted" style={{ "--group": group.color }}>
        <GroupPicture name={group.picture} />
      </span>
      <NameField
        name={group.name}
        label={labels.renameGroup}
        testId="group-rename"
        onRename={(name) => change({ name })}
      >
        <span class="column shrinks">
          <strong class="one-line" dir="auto" data-shortened title={group.name}>
            {group.name}
          </strong>
          <span class="aside">{groupCounts(group, texts.value)}</span>
        </span>
      </NameField>
      {others.length > 0 && (
        <Select
          class="class-groups__move"
          label={labels.moveOf({ name: group.name })}
          testId="move-group"
          value=""
          options={[["", labels.move], ...others]}
          onChange={(id) => id && act(() => move(id))}
        />
      )}
      <FaultLine fault={fault} />
    </>
  );
}
