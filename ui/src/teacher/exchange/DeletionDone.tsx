import type { Ref } from "preact";
import type { Removed } from "../../api/model";
import { texts } from "../../i18n";
import { FilesLeft } from "./FilesLeft";

interface DeletionDoneProps {
  removed: Removed;
  answer: Ref<HTMLDivElement>;
}

/** Report of a deletion, and the files that still contain the data. */
export function DeletionDone({ removed, answer }: DeletionDoneProps) {
  const say = texts.value.exchange;
  const { n_groups, n_programs, n_runs } = removed;
  return (
    <div
      ref={answer}
      class="deletion__done notice-box"
      role="status"
      tabIndex={-1}
      data-testid="deletion-done"
    >
      <p>{say.deletion.done(say.groups(n_groups), say.programs(n_programs), say.runs(n_runs))}</p>
      <FilesLeft paths={[...removed.files.map(({ path }) => path), ...removed.backups]} />
    </div>
  );
}
