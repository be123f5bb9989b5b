import { NO_CLASS } from "../api/classes";
import type { Classroom } from "../api/model";
import { language, texts } from "../i18n";
import { Choice } from "../kit/Choice";
import { setClassroom } from "./classroom";
import { toldApart } from "./namesakes";
import { TEST } from "./testids";

interface ClassChipsProps {
  classes: readonly Classroom[];
  /** Whether there is anything without a class. */
  withNone: boolean;
  shown: string;
}

/** Which class? One chip for each. */
export function ClassChips({ classes, withNone, shown }: ClassChipsProps) {
  const words = texts.value.classes;
  const none = { id: NO_CLASS, name: words.noClass };
  return (
    <Choice
      label={words.choose}
      class="class-chips"
      optionClass="class-chips__one"
      testId={TEST.classChip}
      value={shown}
      options={[...toldApart(classes, language.value), ...(withNone ? [none] : [])].map(
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
