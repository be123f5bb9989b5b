import type { Group } from "../api/model";
import type { Texts } from "../i18n";

/** Text with the numbers of a group's programs, programs in the bin, and runs. */
export function groupCounts(group: Group, { start }: Texts): string {
  const { n_programs, n_in_bin, n_runs } = group;
  if (n_programs + n_in_bin + n_runs === 0) return start.nothingYet;
  const bin = n_programs > 0 ? start.alsoInBin({ n: n_in_bin }) : start.inBin({ count: n_in_bin });
  return [
    (n_programs > 0 || n_in_bin === 0) && start.programs({ count: n_programs }),
    n_in_bin > 0 && bin,
    start.runs({ count: n_runs }),
  ]
    .filter(Boolean)
    .join(" · ");
}
