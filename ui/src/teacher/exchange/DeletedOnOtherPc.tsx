import { useState } from "preact/hooks";
import type { PendingDeletion, PendingWork } from "../../api/model";
import { texts } from "../../i18n";
import { ConfirmDeletion } from "./ConfirmDeletion";
import { counted, newsOf } from "./outcome";

interface DeletedOnOtherPcProps {
  computer: string;
  pending: PendingDeletion;
  onDelete(retained: readonly string[]): Promise<void>;
  onDecline(): void;
}

/** Asks whether to apply another PC's deletion here. Preselects moved and newer work, to be retained. */
export function DeletedOnOtherPc({
  computer,
  pending,
  onDelete,
  onDecline,
}: DeletedOnOtherPcProps) {
  const labels = texts.value.exchange;
  const newer = pending.work.filter(({ is_newer }) => is_newer).map(({ id }) => id);
  const [retained, setRetained] = useState<ReadonlySet<string>>(new Set(newer));
  const toggle = (id: string) => {
    const others = new Set(retained);
    if (!others.delete(id)) others.add(id);
    setRetained(others);
  };
  return (
    <ConfirmDeletion
      confirm={retained.size > 0 ? labels.deleteRest : labels.deleteToo}
      cancel={labels.keepHere}
      testId="would-delete"
      confirmId="delete-too"
      onConfirm={() => onDelete([...retained])}
      onCancel={onDecline}
    >
      {labels.doomed({
        computer,
        names: pending.names.join(", "),
        work: counted(pending, labels) || labels.programs({ count: 0 }),
      })}
      {pending.work.length > 0 && <span class="deletion__ask">{labels.whatToKeep}</span>}
      {pending.work.map((work) => (
        <WorkRow
          key={work.id}
          work={work}
          isRetained={retained.has(work.id)}
          onToggle={() => toggle(work.id)}
        />
      ))}
    </ConfirmDeletion>
  );
}

interface WorkRowProps {
  work: PendingWork;
  isRetained: boolean;
  onToggle(): void;
}

/** A group or program that can be retained, with its work that the deleting PC did not have. */
function WorkRow({ work, isRetained, onToggle }: WorkRowProps) {
  const labels = texts.value.exchange;
  const news = newsOf(work, labels);
  const isGroup = work.kind === "group";
  const content = counted({ programs: isGroup ? work.n_programs : 0, runs: work.n_runs }, labels);
  return (
    <label class="deletion__work row middle gap-3" data-testid="can-keep">
      <input type="checkbox" checked={isRetained} onChange={onToggle} />
      <span>
        <strong>
          {isGroup ? work.name : labels.programOf({ name: work.name, group: work.place })}
        </strong>
        {`: ${content || (isGroup ? labels.programs({ count: 0 }) : labels.runs({ count: 0 }))}`}
        {news && <span class="deletion__news">{news}</span>}
      </span>
    </label>
  );
}
