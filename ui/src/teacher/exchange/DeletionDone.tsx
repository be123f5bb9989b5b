import type { Ref } from "preact";
import type { Removed } from "../../api/model";
import { texts } from "../../i18n";
import { FilesLeft } from "./FilesLeft";

interface DeletionDoneProps {
  removed: Removed;
  elementRef: Ref<HTMLDivElement>;
}

/** Report of a deletion, and the files that still contain the data. */
export function DeletionDone({ removed, elementRef }: DeletionDoneProps) {
  const labels = texts.value.exchange;
  const { n_groups, n_programs, n_runs } = removed;
  return (
    <div
      ref={elementRef}
      class="deletion__done notice-box"
      role="status"
      tabIndex={-1}
      data-testid="deletion-done"
    >
      <p>
        {labels.deletion.done({
          groups: labels.groups({ count: n_groups }),
          programs: labels.programs({ count: n_programs }),
          runs: labels.runs({ count: n_runs }),
        })}
      </p>
      <FilesLeft paths={[...removed.files.map(({ path }) => path), ...removed.backups]} />
    </div>
  );
}
