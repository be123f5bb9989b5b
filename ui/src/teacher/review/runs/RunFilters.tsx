import type { Signal } from "@preact/signals";
import { FilterX } from "lucide-preact";
import { NO_CLASS } from "../../../api/classes";
import { type Lesson, OWN_WORLD, worldTitle } from "../../../api/model";
import type { RunFilter } from "../../../api/review";
import { language, texts } from "../../../i18n";
import { Button } from "../../../kit/Button";
import { Select, type SelectOption } from "../../../kit/Select";
import { withDistinctNames } from "../../../shell/namesakes";
import { worlds } from "../../../shell/session";
import { dateAndTime } from "../../time_format";
import { DayField } from "./DayField";
import { type FilterChoices, NO_FILTER } from "./run_list";

const OUTCOMES = ["passed", "not_passed", "finished", "stopped", "failed"] as const;

type Options = readonly SelectOption<string>[];

interface RunFiltersProps {
  filter: Signal<RunFilter>;
  choices: FilterChoices;
}

/** Filters by class, group, lesson, activity, world, day and outcome. */
export function RunFilters({ filter, choices }: RunFiltersProps) {
  const { runs: labels } = texts.value.review;
  const props = { filter, all: labels.all };
  const clear = () => {
    filter.value = NO_FILTER;
  };
  return (
    <div class="filters">
      <SelectFilter {...props} name="classroom" options={classOptions(choices)} />
      <SelectFilter
        {...props}
        name="group"
        all={labels.allGroups}
        options={groupOptions(choices, filter.value.classroom)}
      />
      <SelectFilter
        {...props}
        name="lesson"
        options={lessonOptions(choices, filter.value.classroom)}
      />
      <SelectFilter
        {...props}
        name="activity"
        options={choices.activities.map(({ name, title }) => [name, title])}
      />
      <SelectFilter {...props} name="world" all={labels.allGroups} options={worldOptions()} />
      <DayField
        value={filter.value.day}
        onDay={(day) => {
          filter.value = { ...filter.value, day };
        }}
      />
      <SelectFilter
        {...props}
        name="outcome"
        all={labels.allGroups}
        options={OUTCOMES.map((name) => [name, labels.outcomes[name]])}
      />
      {Object.values(filter.value).some(Boolean) && (
        <Button icon={FilterX} onPress={clear}>
          {labels.clear}
        </Button>
      )}
    </div>
  );
}

const classOptions = ({ classes }: FilterChoices): Options => [
  ...withDistinctNames(classes, language.value).map(({ id, name }) => [id, name] as const),
  [NO_CLASS, texts.value.review.lesson.noClass],
];

function groupOptions({ groups }: FilterChoices, classroom: string): Options {
  return groups
    .filter(({ classroom_id }) => !classroom || (classroom_id ?? NO_CLASS) === classroom)
    .map(({ id, name }) => [id, name] as const)
    .sort(([, a], [, b]) => a.localeCompare(b, language.value, { numeric: true }));
}

/** Lessons with their dates. Choosing a lesson includes its parts; a part whose lesson is missing has an option. */
function lessonOptions({ lessons }: FilterChoices, classroom: string): Options {
  const { untitled } = texts.value.review.lesson;
  const isPart = ({ part_of }: Lesson) => lessons.some(({ id }) => id === part_of);
  return lessons
    .filter((lesson) => !isPart(lesson))
    .filter(({ classroom_id }) => !classroom || (classroom_id ?? NO_CLASS) === classroom)
    .map((one) => [
      one.id,
      `${one.title || untitled} · ${dateAndTime(one.opened_at, language.value)}`,
    ]);
}

function worldOptions(): Options {
  const own: SelectOption<string> = [OWN_WORLD, texts.value.world.own];
  return [
    ...worlds.value.map(
      (world): SelectOption<string> => [world.name, worldTitle(world, language.value)],
    ),
    own,
  ];
}

interface SelectFilterProps {
  filter: Signal<RunFilter>;
  name: Exclude<keyof RunFilter, "day">;
  /** Label of the empty choice. */
  all: string;
  options: Options;
}

function SelectFilter({ filter, name, all, options }: SelectFilterProps) {
  const value = filter.value[name];
  return (
    <label class="filters__one">
      <span>{texts.value.review.runs[name]}</span>
      <Select
        class="filters__select"
        value={value}
        options={[["", all], ...options]}
        testId="history-filter"
        data-name={name}
        data-on={value !== ""}
        onChange={(chosen) => {
          // the filters of group and lesson depend on the class
          const ofClass = name === "classroom" ? { group: "", lesson: "" } : {};
          filter.value = { ...filter.value, ...ofClass, [name]: chosen };
        }}
      />
    </label>
  );
}
