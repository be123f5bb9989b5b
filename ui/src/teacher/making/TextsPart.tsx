import { STORE_LIMITS } from "../../api/declared";
import { blockText, type TextKey } from "../../blocks/texts";
import { texts } from "../../i18n";
import { Field } from "../../kit/Field";
import { NumberField } from "../../kit/NumberField";
import { LabelledSelect } from "../../kit/Select";
import { LEVELS, levelNames } from "../../shell/level";
import type { ActivityEditor } from "./activity_editor";
import { criteriaOf } from "./criteria";
import { blocksNotOffered } from "./level_notices";
import { TextArea } from "./TextArea";

/** Fields for title, story, criteria, hints and the question after the run. */
export function TextsPart({ editor }: { editor: ActivityEditor }) {
  const { making: labels } = texts.value;
  const { title, story, question } = editor.written.value;
  return (
    <section class="making__part">
      <h2>{labels.texts.title}</h2>
      <Field
        label={labels.texts.name}
        placeholder={labels.texts.namePlaceholder}
        maxLength={STORE_LIMITS.MAX_NAME}
        data-testid="making-title"
        value={title}
        onText={(text) => editor.write({ title: text })}
      />
      <TextArea
        label={labels.texts.story}
        value={story}
        testId="making-story"
        onText={(text) => editor.write({ story: text })}
      />
      <Criteria editor={editor} />
      <Hints editor={editor} />
      <TextArea
        label={labels.texts.question}
        value={question}
        rows={1}
        onText={(text) => editor.write({ question: text })}
      />
      <LevelAndTime editor={editor} />
    </section>
  );
}

/** Field for the criteria; if it is empty, the mission card describes the chosen checks. */
function Criteria({ editor }: { editor: ActivityEditor }) {
  const { making: labels } = texts.value;
  const { value: choices } = editor.choices;
  return (
    <TextArea
      label={labels.texts.criteria}
      value={editor.written.value.criteria}
      placeholder={choices ? criteriaOf(choices, labels) : ""}
      onText={(criteria) => editor.write({ criteria })}
    />
  );
}

function Hints({ editor }: { editor: ActivityEditor }) {
  const { making: labels } = texts.value;
  const { hints } = editor.written.value;
  const { value: level } = editor.level;
  const change = (index: number, text: string) => {
    const [first, second, third] = hints.map((hint, at) => (at === index ? text : hint));
    editor.write({ hints: [first ?? "", second ?? "", third ?? ""] });
  };
  return (
    <>
      {hints.map((hint, index) => {
        const unknown = blocksNotOffered(hint, level, labelOf);
        return (
          <div key={index}>
            <TextArea
              label={labels.texts.hint({ n: index + 1 })}
              value={hint}
              rows={1}
              testId="making-hint"
              onText={(text) => change(index, text)}
            />
            {unknown.length > 0 && (
              <p class="notice-box" role="status" data-testid="making-notice">
                {labels.texts.notOffered({
                  blocks: unknown.map((text) => texts.value.show.quoted({ text })).join(", "),
                  level: levelNames()[level],
                })}
              </p>
            )}
          </div>
        );
      })}
    </>
  );
}

const labelOf = (type: string) => blockText(type.toUpperCase() as TextKey);

function LevelAndTime({ editor }: { editor: ActivityEditor }) {
  const { making: labels } = texts.value;
  const { value: level } = editor.level;
  const needed = editor.levelOfSolution.value;
  return (
    <>
      <div class="teacher__row">
        <LabelledSelect
          label={labels.texts.level}
          value={level}
          options={LEVELS.map((one) => [one, levelNames()[one]])}
          onChange={(one) => {
            editor.level.value = one;
          }}
        />
        <NumberField
          label={labels.texts.minutes}
          value={editor.minutes.value}
          {...{ min: 1, max: 600, step: 5 }}
          testId="making-minutes"
          onNumber={(minutes) => {
            editor.minutes.value = minutes;
          }}
        />
      </div>
      {needed > level && (
        <p class="notice-box" role="status">
          {labels.texts.levelTooLow({ level: levelNames()[needed] })}
        </p>
      )}
      <label class="making__choice row middle gap-2">
        <input
          type="checkbox"
          checked={editor.showsPath.value}
          onChange={({ currentTarget }) => {
            editor.showsPath.value = currentTarget.checked;
          }}
        />
        {labels.texts.showsPath}
      </label>
    </>
  );
}
