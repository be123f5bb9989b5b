import { Trash2 } from "lucide-preact";
import type { ComponentChildren } from "preact";
import { useState } from "preact/hooks";
import { exchange } from "../../api/exchange";
import type { Classroom, Group, Removed } from "../../api/model";
import { texts } from "../../i18n";
import { useAction } from "../../kit/requests/action";
import { FaultLine } from "../../kit/requests/FaultLine";
import { Select, type SelectOption } from "../../kit/Select";
import { asTeacher } from "../../shell/teacher/teacher_session";
import { ConfirmDeletion } from "./ConfirmDeletion";

interface DeletionProps {
  classroom: Classroom | undefined;
  groups: readonly Group[];
  onDone(removed: Removed): Promise<void>;
  /** Report of the last deletion. */
  children?: ComponentChildren;
}

/** Deletes a group or the whole class for good, after showing the number of lost programs and runs. */
export function Deletion({ classroom, groups, onDone, children }: DeletionProps) {
  const [chosen, setChosen] = useState("");
  const { fault, act } = useAction(asTeacher);
  const { deletion } = texts.value.exchange;
  const isClass = chosen === classroom?.id;
  const affected = isClass ? groups : groups.filter(({ id }) => id === chosen);
  const name = isClass
    ? `${classroom.name} (${texts.value.exchange.groups({ count: groups.length })})`
    : (affected[0]?.name ?? "");
  const remove = async () => {
    const removed = await (isClass ? exchange.deleteClassroom : exchange.deleteGroup)(chosen);
    setChosen("");
    await onDone(removed);
  };
  return (
    <details class="deletion">
      <summary data-testid="deletion-open">
        <Trash2 class="icon" aria-hidden="true" />
        {deletion.title}
      </summary>
      <p class="exchange__hint">{deletion.hint}</p>
      <Select
        class="deletion__what"
        label={deletion.what}
        testId="deletion-what"
        value={chosen}
        options={[
          ["", deletion.nothing],
          ...groups.map(
            (one): SelectOption<string> => [one.id, deletion.group({ name: one.name })],
          ),
          ...(classroom
            ? [[classroom.id, deletion.classroom({ name: classroom.name })] as const]
            : []),
        ]}
        onChange={(id) => setChosen(id)}
      />
      {chosen && (
        <ConfirmDeletion
          confirm={deletion.go}
          cancel={deletion.cancel}
          confirmId="deletion-go"
          onConfirm={() => act(remove)}
          onCancel={() => setChosen("")}
        >
          {lossText(name, affected)}
        </ConfirmDeletion>
      )}
      <FaultLine fault={fault} />
      {children}
    </details>
  );
}

/** Text about the programs and runs that will be lost. */
function lossText(name: string, groups: readonly Group[]): string {
  const labels = texts.value.exchange;
  const total = (count: (group: Group) => number) =>
    groups.reduce((sum, group) => sum + count(group), 0);
  const inBin = total((group) => group.n_in_bin);
  const all = labels.programs({ count: total((group) => group.n_programs) + inBin });
  const programs = inBin > 0 ? `${all} (${texts.value.start.alsoInBin({ n: inBin })})` : all;
  return labels.deletion.goes({
    name,
    programs,
    runs: labels.runs({ count: total((group) => group.n_runs) }),
  });
}
