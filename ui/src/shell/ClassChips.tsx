import { NO_CLASS } from "../api/classes";
import type { Classroom } from "../api/model";
import { language, texts } from "../i18n";
import { RadioGroup } from "../kit/RadioGroup";
import { setClassroom } from "./classroom";
import { withDistinctNames } from "./namesakes";

interface ClassChipsProps {
  classes: readonly Classroom[];
  /** Whether to offer a chip for groups without a class. */
  withNone: boolean;
  shown: string;
}

/** Selects a class: one chip for each. */
export function ClassChips({ classes, withNone, shown }: ClassChipsProps) {
  const labels = texts.value.classes;
  const none = { id: NO_CLASS, name: labels.noClass };
  return (
    <RadioGroup
      label={labels.choose}
      class="class-chips row wrap gap-2"
      optionClass="class-chips__one"
      testId="class-chip"
      value={shown}
      options={[...withDistinctNames(classes, language.value), ...(withNone ? [none] : [])].map(
        ({ id, name }) => [
          id,
          <span key={id} class="class-chips__name" data-shortened>
            {name}
          </span>,
          { tip: name },
        ],
      )}
      onChange={setClassroom}
    />
  );
}
