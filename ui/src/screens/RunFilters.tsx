import { ChevronDown, CircleCheck, CircleStop, CircleX } from "lucide-preact";
import type { Program } from "../api/model";
import { report } from "../app/session";
import { TEST } from "../app/testids";
import { texts } from "../i18n";
import { OUTCOMES, type RunList } from "./run_list";

const ICONS = { finished: CircleCheck, stopped: CircleStop, failed: CircleX } as const;

/** Which runs are shown: how they ended, and of which program. */
export function RunFilters({ list, programs }: { list: RunList; programs: readonly Program[] }) {
  const { keeping } = texts.value;
  const { value: outcome } = list.outcome;
  const { value: program } = list.program;
  return (
    <fieldset class="run-filters">
      <legend class="visually-hidden">{keeping.filters}</legend>
      {([null, ...OUTCOMES] as const).map((one) => {
        const Icon = one && ICONS[one];
        return (
          <button
            key={one}
            type="button"
            class="button"
            aria-pressed={outcome === one}
            data-testid={TEST.runFilter}
            data-outcome={one ?? "all"}
            onClick={() => void list.choose(one, program).catch(report)}
          >
            {Icon && <Icon class="icon" aria-hidden="true" />}
            {one ? keeping.outcomes[one] : keeping.allRuns}
          </button>
        );
      })}
      {programs.length > 1 && (
        <span class="select run-filters__program">
          <select
            aria-label={keeping.ofProgram}
            data-testid={TEST.runProgram}
            value={program ?? ""}
            onChange={({ currentTarget: { value } }) =>
              void list.choose(outcome, value || null).catch(report)
            }
          >
            <option value="">{keeping.allPrograms}</option>
            {programs.map((one) => (
              <option key={one.id} value={one.id}>
                {one.name}
              </option>
            ))}
          </select>
          <ChevronDown class="icon icon--end" aria-hidden="true" />
        </span>
      )}
    </fieldset>
  );
}
