import { ChevronDown } from "lucide-preact";
import type { ComponentChildren } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { classesApi, NO_CLASS } from "../api/classes";
import type { Removed } from "../api/exchange";
import type { Group } from "../api/model";
import { classroom, groupsIn, setClassroom, shownClass } from "../app/classroom";
import { toldApart } from "../app/namesakes";
import { TEST } from "../app/testids";
import { Deletion, Gone } from "../exchange/Deletion";
import { language, texts } from "../i18n";
import { ClassChips } from "../screens/ClassChips";
import { GroupPicture } from "../screens/GroupPicture";
import { groupCounts } from "../screens/group_counts";
import { AddForm } from "./AddForm";
import { useAct } from "./act";
import { FaultLine } from "./FaultLine";
import { NameField } from "./NameField";
import type { School } from "./TeacherScreen";
import { words } from "./words";

/** The classes of the school, and who is in them. */
export function ClassesPart({ school }: { school: School }) {
  const { classes: say } = words.value;
  const { classes, groups, reload } = school;
  const shown = shownClass(classroom.value, classes, groups);
  const withNone = groupsIn(NO_CLASS, groups).length > 0;
  const hasPanel = classes.length > 0 || withNone;
  const { gone, from, setDeleted } = useDeleted();
  // the class itself may be what is gone
  const inPanel = hasPanel && from === shown;

  const make = async (name: string) => {
    const made = await classesApi.createClassroom(name);
    await reload();
    setClassroom(made.id);
  };

  return (
    <>
      <div class="teacher__head">
        <h1>{say.title}</h1>
        <AddForm
          label={say.newClass}
          placeholder={say.newClassPlaceholder}
          fieldId={TEST.newClass}
          buttonId={TEST.makeClass}
          onAdd={make}
        />
      </div>
      {!inPanel && gone}
      {classes.length === 0 && <p class="teacher__hint">{say.first}</p>}
      {classes.length > 0 && <ClassChips classes={classes} withNone={withNone} shown={shown} />}
      {hasPanel && (
        <ClassPanel key={shown} id={shown} school={school} onRemoved={setDeleted}>
          {inPanel && gone}
        </ClassPanel>
      )}
    </>
  );
}

/** What was deleted last, said where the eyes are: whoever deletes reads where it may still be. */
function useDeleted() {
  const [deleted, setDeleted] = useState<Deleted | null>(null);
  const answer = useRef<HTMLDivElement>(null);
  useEffect(() => {
    answer.current?.focus();
    answer.current?.scrollIntoView({ block: "nearest" });
  }, [deleted]);
  return {
    gone: deleted && <Gone removed={deleted.removed} answer={answer} />,
    from: deleted?.classroom,
    setDeleted,
  };
}

interface Deleted {
  removed: Removed;
  classroom: string;
}

interface ClassPanelProps {
  id: string;
  school: School;
  onRemoved(deleted: Deleted): void;
  children: ComponentChildren;
}

function ClassPanel({ id, school, onRemoved, children }: ClassPanelProps) {
  const { classes: say } = words.value;
  const { reload } = school;
  const [moved, setMoved] = useState("");
  const here = groupsIn(id, school.groups);
  const now = school.classes.find((one) => one.id === id);
  const shown = toldApart(school.classes, language.value).find((one) => one.id === id);

  const rename = async (name: string) => {
    await classesApi.renameClassroom(id, name);
    await reload();
  };
  const forget = async (removed: Removed) => {
    try {
      await reload();
    } finally {
      onRemoved({ removed, classroom: id });
    }
  };
  const add = async (name: string) => {
    await classesApi.createGroup({ name, classroom_id: id });
    await reload();
  };

  return (
    <section class="panel card">
      {now ? (
        <NameField name={now.name} label={say.rename} testId={TEST.renameClass} onRename={rename}>
          <h2>{shown?.name}</h2>
        </NameField>
      ) : (
        <>
          <h2>{texts.value.classes.noClass}</h2>
          <p class="teacher__hint">{say.noneHint}</p>
        </>
      )}
      <p class="teacher__hint" role="status">
        {moved || (here.length === 0 ? say.empty : say.groups(here.length))}
      </p>
      <ul class="class-groups">
        {here.map((group) => (
          <li key={group.id} class="class-groups__one" data-testid={TEST.classGroup}>
            <ClassGroup group={group} school={school} onMoved={setMoved} />
          </li>
        ))}
      </ul>
      {now && (
        <AddForm
          label={say.newGroup}
          placeholder={say.newGroupPlaceholder}
          fieldId={TEST.newGroupName}
          buttonId={TEST.makeGroup}
          onAdd={add}
        />
      )}
      {(now || here.length > 0) && (
        <Deletion classroom={shown} groups={here} onDone={forget}>
          {children}
        </Deletion>
      )}
    </section>
  );
}

interface ClassGroupProps {
  group: Group;
  school: School;
  onMoved(words: string): void;
}

function ClassGroup({ group, school, onMoved }: ClassGroupProps) {
  const { classes: say } = words.value;
  const { fault, act } = useAct();
  const others = toldApart(school.classes, language.value).filter(
    (one) => one.id !== group.classroom_id,
  );

  const rename = async (name: string) => {
    await classesApi.changeGroup(group.id, { name });
    await school.reload();
  };
  const move = async (id: string) => {
    await classesApi.changeGroup(group.id, { classroom_id: id });
    await school.reload();
    onMoved(say.moved(group.name, others.find((one) => one.id === id)?.name ?? ""));
  };

  return (
    <>
      <span class="badge badge--middle tinted" style={{ "--group": group.color }}>
        <GroupPicture name={group.picture} />
      </span>
      <NameField
        name={group.name}
        label={say.renameGroup}
        testId={TEST.groupRename}
        onRename={rename}
      >
        <span class="class-groups__words">
          <strong class="class-groups__name" dir="auto" data-shortened title={group.name}>
            {group.name}
          </strong>
          <span class="class-groups__counts">{groupCounts(group, texts.value)}</span>
        </span>
      </NameField>
      {others.length > 0 && (
        <span class="select class-groups__move">
          <select
            aria-label={say.moveOf(group.name)}
            data-testid={TEST.moveGroup}
            value=""
            onChange={({ currentTarget }) => {
              const wanted = currentTarget.value;
              currentTarget.value = "";
              if (wanted) void act(() => move(wanted));
            }}
          >
            <option value="">{say.move}</option>
            {others.map((one) => (
              <option key={one.id} value={one.id}>
                {one.name}
              </option>
            ))}
          </select>
          <ChevronDown class="icon icon--end" aria-hidden="true" />
        </span>
      )}
      <FaultLine fault={fault} />
    </>
  );
}
