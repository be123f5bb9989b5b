import { CircleCheck, CircleStop, CircleX } from "lucide-preact";
import type { Program } from "../api/model";
import { texts } from "../i18n";
import { Button } from "../kit/Button";
import { Select } from "../kit/Select";
import { END_STATES, type RunList } from "./run_list";

const ICONS = { finished: CircleCheck, stopped: CircleStop, failed: CircleX } as const;

/** Filters runs by outcome and program. */
export function RunFilters({ list, programs }: { list: RunList; programs: readonly Program[] }) {
  const { archive } = texts.value;
  const { value: outcome } = list.outcome;
  const { value: program } = list.program;
  return (
    <fieldset class="run-filters row wrap middle gap-2">
      <legend class="visually-hidden">{archive.filters}</legend>
      {([null, ...END_STATES] as const).map((one) => (
        <Button
          key={one}
          icon={one && ICONS[one]}
          pressed={outcome === one}
          testId="run-filter"
          data-outcome={one ?? "all"}
          onPress={() => list.choose(one, program)}
        >
          {one ? archive.outcomes[one] : archive.allRuns}
        </Button>
      ))}
      {programs.length > 1 && (
        <Select
          class="run-filters__program"
          label={archive.ofProgram}
          testId="run-program"
          value={program}
          options={[
            [null, archive.allPrograms],
            ...programs.map(({ id, name }) => [id, name] as const),
          ]}
          onChange={(chosen) => list.choose(outcome, chosen)}
        />
      )}
    </fieldset>
  );
}
