import { useState } from "preact/hooks";
import type { PendingDeletion, PendingWork } from "../../api/model";
import { texts } from "../../i18n";
import { ConfirmDeletion } from "./ConfirmDeletion";
import { counted, newsOf } from "./outcome";

interface DeletedElsewhereProps {
  computer: string;
  pending: PendingDeletion;
  onDelete(kept: readonly string[]): Promise<void>;
  onKeep(): void;
}

/** Asks whether what another PC deleted goes here too; what was moved or is newer here is marked to be kept. */
export function DeletedElsewhere({ computer, pending, onDelete, onKeep }: DeletedElsewhereProps) {
  const say = texts.value.exchange;
  const newer = pending.work.filter(({ is_newer }) => is_newer).map(({ id }) => id);
  const [kept, setKept] = useState<ReadonlySet<string>>(new Set(newer));
  const toggle = (id: string) => {
    const others = new Set(kept);
    if (!others.delete(id)) others.add(id);
    setKept(others);
  };
  return (
    <ConfirmDeletion
      confirm={kept.size > 0 ? say.deleteRest : say.deleteToo}
      cancel={say.keepHere}
      testId="would-delete"
      confirmId="delete-too"
      onConfirm={() => onDelete([...kept])}
      onCancel={onKeep}
    >
      {say.doomed(computer, pending.names.join(", "), counted(pending, say) || say.programs(0))}
      {pending.work.length > 0 && <span class="deletion__ask">{say.whatToKeep}</span>}
      {pending.work.map((work) => (
        <WorkLine
          key={work.id}
          work={work}
          isKept={kept.has(work.id)}
          onToggle={() => toggle(work.id)}
        />
      ))}
    </ConfirmDeletion>
  );
}

interface WorkLineProps {
  work: PendingWork;
  isKept: boolean;
  onToggle(): void;
}

/** A group or program that can be kept, with what was unknown where it was deleted. */
function WorkLine({ work, isKept, onToggle }: WorkLineProps) {
  const say = texts.value.exchange;
  const news = newsOf(work, say);
  const isGroup = work.kind === "group";
  const content = counted({ programs: isGroup ? work.n_programs : 0, runs: work.n_runs }, say);
  return (
    <label class="deletion__work row middle gap-3" data-testid="can-keep">
      <input type="checkbox" checked={isKept} onChange={onToggle} />
      <span>
        <strong>{isGroup ? work.name : say.programOf(work.name, work.place)}</strong>
        {`: ${content || (isGroup ? say.programs(0) : say.runs(0))}`}
        {news && <span class="deletion__news">{news}</span>}
      </span>
    </label>
  );
}
