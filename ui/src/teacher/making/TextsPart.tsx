import { STORE_LIMITS } from "../../api/declared";
import { type TextKey, word } from "../../blocks/words";
import { texts } from "../../i18n";
import { Field } from "../../kit/Field";
import { NumberField } from "../../kit/NumberField";
import { Select } from "../../kit/Select";
import { LEVELS, levelNames } from "../../shell/level";
import { criteriaOf } from "./criteria";
import { blocksNotOffered } from "./level_notices";
import type { Maker } from "./maker";
import { TextArea } from "./TextArea";

/** Title, story, what counts, hints and the question afterwards. */
export function TextsPart({ maker }: { maker: Maker }) {
  const { making: say } = texts.value;
  const { title, story, question } = maker.written.value;
  return (
    <section class="making__part">
      <h2>{say.texts.title}</h2>
      <Field
        label={say.texts.name}
        placeholder={say.texts.namePlaceholder}
        maxLength={STORE_LIMITS.MAX_NAME}
        data-testid="making-title"
        value={title}
        onText={(text) => maker.write({ title: text })}
      />
      <TextArea
        label={say.texts.story}
        value={story}
        testId="making-story"
        onText={(text) => maker.write({ story: text })}
      />
      <Criteria maker={maker} />
      <Hints maker={maker} />
      <TextArea
        label={say.texts.question}
        value={question}
        rows={1}
        onText={(text) => maker.write({ question: text })}
      />
      <LevelAndTime maker={maker} />
    </section>
  );
}

/** Without a text of its own the card says what was chosen. */
function Criteria({ maker }: { maker: Maker }) {
  const { making: say } = texts.value;
  const { value: choices } = maker.choices;
  return (
    <TextArea
      label={say.texts.criteria}
      value={maker.written.value.criteria}
      placeholder={choices ? criteriaOf(choices, say) : ""}
      onText={(criteria) => maker.write({ criteria })}
    />
  );
}

function Hints({ maker }: { maker: Maker }) {
  const { making: say } = texts.value;
  const { hints } = maker.written.value;
  const { value: level } = maker.level;
  const change = (index: number, text: string) => {
    const [first, second, third] = hints.map((hint, at) => (at === index ? text : hint));
    maker.write({ hints: [first ?? "", second ?? "", third ?? ""] });
  };
  return (
    <>
      {hints.map((hint, index) => {
        const unknown = blocksNotOffered(hint, level, labelOf);
        return (
          <div key={index}>
            <TextArea
              label={say.texts.hint(index + 1)}
              value={hint}
              rows={1}
              testId="making-hint"
              onText={(text) => change(index, text)}
            />
            {unknown.length > 0 && (
              <p class="notice-box" role="status" data-testid="making-notice">
                {say.texts.notOffered(unknown.join("”, “"), levelNames()[level])}
              </p>
            )}
          </div>
        );
      })}
    </>
  );
}

const labelOf = (type: string) => word(type.toUpperCase() as TextKey);

function LevelAndTime({ maker }: { maker: Maker }) {
  const { making: say } = texts.value;
  const { value: level } = maker.level;
  const needed = maker.levelOfSolution.value;
  return (
    <>
      <div class="teacher__row">
        <label class="labelled">
          <span class="labelled__label">{say.texts.level}</span>
          <Select
            value={level}
            options={LEVELS.map((one) => [one, levelNames()[one]])}
            onChange={(one) => {
              maker.level.value = one;
            }}
          />
        </label>
        <NumberField
          label={say.texts.minutes}
          value={maker.minutes.value}
          {...{ least: 1, most: 600, step: 5 }}
          testId="making-minutes"
          onNumber={(minutes) => {
            maker.minutes.value = minutes;
          }}
        />
      </div>
      {needed > level && (
        <p class="notice-box" role="status">
          {say.texts.levelTooLow(levelNames()[needed])}
        </p>
      )}
      <label class="making__choice row wrap middle gap-2">
        <input
          type="checkbox"
          checked={maker.showsPath.value}
          onChange={({ currentTarget }) => {
            maker.showsPath.value = currentTarget.checked;
          }}
        />
        {say.texts.showsPath}
      </label>
    </>
  );
}
