import type { Signal } from "@preact/signals";
import { ChevronDown, FilterX } from "lucide-preact";
import type { ActivityTitle, Classroom, Group } from "../api/model";
import type { RunFilter } from "../api/review";
import { toldApart } from "../app/namesakes";
import { TEST } from "../app/testids";
import { language } from "../i18n";
import { words } from "../i18n/review";

/** What can be chosen. */
export interface School {
  classrooms: Classroom[];
  groups: Group[];
  activities: ActivityTitle[];
}

const OUTCOMES = ["passed", "not_passed", "finished", "stopped", "failed"] as const;
export const NO_FILTER: RunFilter = {
  classroom: "",
  group: "",
  activity: "",
  day: "",
  outcome: "",
};

interface RunFiltersProps {
  filter: Signal<RunFilter>;
  school: School;
}

type Option = readonly [value: string, label: string];

/** Class, group, activity, day and outcome. */
export function RunFilters({ filter, school }: RunFiltersProps) {
  const texts = words.value.runs;
  const now = filter.value;
  const set = (changes: Partial<RunFilter>) => {
    filter.value = { ...now, ...changes };
  };
  const groups = school.groups
    .filter(({ classroom_id }) => !now.classroom || (classroom_id ?? "none") === now.classroom)
    .map(({ id, name }): Option => [id, name])
    .sort(([, a], [, b]) => a.localeCompare(b, language.value, { numeric: true }));
  return (
    <div class="filters">
      <Choice
        name="classroom"
        label={texts.classroom}
        all={texts.all}
        value={now.classroom}
        options={[
          ...toldApart(school.classrooms, language.value).map(({ id, name }): Option => [id, name]),
          ["none", words.value.lesson.noClass],
        ]}
        onChoose={(classroom) => set({ classroom, group: "" })}
      />
      <Choice
        name="group"
        label={texts.group}
        all={texts.allGroups}
        value={now.group}
        options={groups}
        onChoose={(group) => set({ group })}
      />
      <Choice
        name="activity"
        label={texts.activity}
        all={texts.all}
        value={now.activity}
        options={school.activities.map(({ name, title }): Option => [name, title])}
        onChoose={(activity) => set({ activity })}
      />
      <label class="filters__one">
        <span>{texts.day}</span>
        <input
          type="date"
          class="filters__day"
          value={now.day}
          data-testid={TEST.historyFilter}
          data-name="day"
          data-on={now.day !== ""}
          onChange={(event) => set({ day: event.currentTarget.value })}
        />
      </label>
      <Choice
        name="outcome"
        label={texts.outcome}
        all={texts.allGroups}
        value={now.outcome}
        options={OUTCOMES.map((name): Option => [name, texts.outcomes[name]])}
        onChoose={(outcome) => set({ outcome })}
      />
      {Object.values(now).some(Boolean) && (
        <button
          type="button"
          class="button filters__clear"
          onClick={() => {
            filter.value = NO_FILTER;
          }}
        >
          <FilterX class="icon" aria-hidden="true" />
          {texts.clear}
        </button>
      )}
    </div>
  );
}

interface ChoiceProps {
  name: keyof RunFilter;
  label: string;
  /** The words for no choice. */
  all: string;
  value: string;
  options: readonly Option[];
  onChoose(value: string): void;
}

function Choice({ name, label, all, value, options, onChoose }: ChoiceProps) {
  return (
    <label class="filters__one">
      <span>{label}</span>
      <span class="select filters__select">
        <select
          value={value}
          data-testid={TEST.historyFilter}
          data-name={name}
          data-on={value !== ""}
          onChange={(event) => onChoose(event.currentTarget.value)}
        >
          <option value="">{all}</option>
          {options.map(([key, words]) => (
            <option key={key} value={key}>
              {words}
            </option>
          ))}
        </select>
        <ChevronDown class="icon icon--end" aria-hidden="true" />
      </span>
    </label>
  );
}
