import type { ComponentChildren } from "preact";
import { useState } from "preact/hooks";
import { classesApi } from "../../api/classes";
import type { Removed } from "../../api/model";
import { language, texts } from "../../i18n";
import { groupsIn } from "../../shell/classroom";
import { withDistinctNames } from "../../shell/namesakes";
import { AddForm } from "../AddForm";
import { Deletion } from "../exchange/Deletion";
import { NameField } from "../NameField";
import type { School } from "../school";
import { ClassGroup } from "./ClassGroup";

interface ClassPanelProps {
  /** Id of the class; `NO_CLASS` for the groups without a class. */
  id: string;
  school: School;
  reload(): Promise<void>;
  onDeleted(removed: Removed): Promise<void>;
  /** Report of the last deletion. */
  children: ComponentChildren;
}

/** One class: its name, groups and actions. */
export function ClassPanel({ id, school, reload, onDeleted, children }: ClassPanelProps) {
  const { classes: labels } = texts.value.teacher;
  const [moved, setMoved] = useState("");
  const groups = groupsIn(id, school.groups);
  const classroom = withDistinctNames(school.classes, language.value).find((one) => one.id === id);
  const add = async (name: string) => {
    await classesApi.createGroup({ name, classroom_id: id });
    await reload();
  };
  return (
    <section class="panel card">
      <PanelHead id={id} shownName={classroom?.name} school={school} reload={reload} />
      <p class="teacher__hint" role="status">
        {moved || (groups.length === 0 ? labels.empty : labels.groups({ count: groups.length }))}
      </p>
      <ul class="column">
        {groups.map((group) => (
          <li
            key={group.id}
            class="class-groups__one row wrap middle gap-3"
            data-testid="class-group"
          >
            <ClassGroup group={group} school={school} reload={reload} onMoved={setMoved} />
          </li>
        ))}
      </ul>
      {classroom && (
        <AddForm
          label={labels.newGroup}
          placeholder={labels.newGroupPlaceholder}
          fieldId="new-group-name"
          buttonId="make-group"
          onAdd={add}
        />
      )}
      {(classroom || groups.length > 0) && (
        <Deletion classroom={classroom} groups={groups} onDone={onDeleted}>
          {children}
        </Deletion>
      )}
    </section>
  );
}

interface PanelHeadProps extends Pick<ClassPanelProps, "id" | "school" | "reload"> {
  /** The name with a number if several classes share it. */
  shownName: string | undefined;
}

function PanelHead({ id, shownName, school, reload }: PanelHeadProps) {
  const { classes: labels } = texts.value.teacher;
  const classroom = school.classes.find((one) => one.id === id);
  const rename = async (name: string) => {
    await classesApi.renameClassroom(id, name);
    await reload();
  };
  if (!classroom) {
    return (
      <>
        <h2>{texts.value.classes.noClass}</h2>
        <p class="teacher__hint">{labels.noneHint}</p>
      </>
    );
  }
  return (
    <NameField name={classroom.name} label={labels.rename} testId="rename-class" onRename={rename}>
      <h2>{shownName}</h2>
    </NameField>
  );
}
