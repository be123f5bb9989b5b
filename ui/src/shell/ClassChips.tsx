import { NO_CLASS } from "../api/classes";
import type { Classroom } from "../api/model";
import { setClassroom } from "../app/classroom";
import { toldApart } from "../app/namesakes";
import { TEST } from "../app/testids";
import { language, texts } from "../i18n";

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
    <fieldset class="class-chips">
      <legend class="visually-hidden">{words.choose}</legend>
      {[...toldApart(classes, language.value), ...(withNone ? [none] : [])].map(({ id, name }) => (
        <button
          key={id}
          type="button"
          class="button class-chips__one"
          title={name}
          aria-pressed={id === shown}
          data-testid={TEST.classChip}
          onClick={() => setClassroom(id)}
        >
          <span class="class-chips__name" data-shortened>
            {name}
          </span>
        </button>
      ))}
    </fieldset>
  );
}
