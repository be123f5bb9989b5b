import { useEffect, useRef, useState } from "preact/hooks";
import { classesApi, NO_CLASS } from "../../api/classes";
import type { Removed } from "../../api/model";
import { texts } from "../../i18n";
import { ClassChips } from "../../shell/ClassChips";
import { classroom, groupsIn, setClassroom, shownClass } from "../../shell/classroom";
import { AddForm } from "../AddForm";
import { DeletionDone } from "../exchange/DeletionDone";
import type { School } from "../school";
import { ClassPanel } from "./ClassPanel";

interface ClassesPartProps {
  school: School;
  reload(): Promise<void>;
}

/** The classes of the school, and their groups. */
export function ClassesPart({ school, reload }: ClassesPartProps) {
  const { classes: labels } = texts.value.teacher;
  const { classes, groups } = school;
  const shown = shownClass(classroom.value, classes, groups);
  const withNone = groupsIn(NO_CLASS, groups).length > 0;
  const hasPanel = classes.length > 0 || withNone;
  const { message, deletedFrom, setDeleted } = useDeleted();
  // the panel's class may itself have been deleted
  const isInPanel = hasPanel && deletedFrom === shown;
  const make = async (name: string) => {
    const made = await classesApi.createClassroom(name);
    await reload();
    setClassroom(made.id);
  };
  const afterDeletion = async (removed: Removed) => {
    await reload();
    setDeleted({ removed, classroom: shown });
  };
  return (
    <>
      <div class="row wrap top apart gap-3">
        <h1>{labels.title}</h1>
        <AddForm
          label={labels.newClass}
          placeholder={labels.newClassPlaceholder}
          fieldId="new-class"
          buttonId="make-class"
          onAdd={make}
        />
      </div>
      {!isInPanel && message}
      {classes.length === 0 && <p class="teacher__hint">{labels.first}</p>}
      {classes.length > 0 && <ClassChips classes={classes} withNone={withNone} shown={shown} />}
      {hasPanel && (
        <ClassPanel key={shown} {...{ school, reload }} id={shown} onDeleted={afterDeletion}>
          {isInPanel && message}
        </ClassPanel>
      )}
    </>
  );
}

interface Deleted {
  removed: Removed;
  classroom: string;
}

/** Report of the last deletion; gets the focus, because it names files that may still contain copies. */
function useDeleted() {
  const [deleted, setDeleted] = useState<Deleted | null>(null);
  const answer = useRef<HTMLDivElement>(null);
  useEffect(() => {
    answer.current?.focus();
    answer.current?.scrollIntoView({ block: "nearest" });
  }, [deleted]);
  return {
    message: deleted && <DeletionDone removed={deleted.removed} elementRef={answer} />,
    deletedFrom: deleted?.classroom,
    setDeleted,
  };
}
