import { useSignal } from "@preact/signals";
import { LETTERS, signNames } from "../../camera/signs";
import { texts } from "../../i18n";
import { namedSign } from "../../i18n/phrases";
import { Button } from "../../kit/Button";
import { rove } from "../../kit/roving";
import { Tabs } from "../../kit/Tabs";

/** If there are more signs, a field above them searches by name. */
const MAX_WITHOUT_SEARCH = 12;

interface SignAnswersProps {
  /** The signs that the program compares the answer with. */
  expected: readonly string[];
  onAnswer(result: string): void;
}

/** A button for every answer: letters, taught signs of the class, other signs of the program, none. */
export function SignAnswers({ expected, onAnswer }: SignAnswersProps) {
  const labels = texts.value.capture;
  const others = [...new Set([...signNames.value, ...expected])].filter(
    (name) => !LETTERS.includes(name),
  );
  const first = expected.length > 0 && expected.every((name) => others.includes(name));
  const shown = useSignal<"letters" | "signs">(first ? "signs" : "letters");
  const kinds = [
    ["letters", labels.letters],
    ["signs", labels.signs({ n: others.length })],
  ] as const;
  const hasSigns = others.length > 0;
  return (
    <>
      <div class="capture__by-hand aside">
        <p>{labels.byHand}</p>
        {hasSigns && (
          <Tabs
            label={labels.kinds}
            value={shown.value}
            options={kinds}
            testId="capture-kind"
            onChange={(kind) => {
              shown.value = kind;
            }}
          />
        )}
      </div>
      {hasSigns && shown.value === "signs" ? (
        <Signs names={others} onAnswer={onAnswer} />
      ) : (
        <div class="capture__letters">
          {LETTERS.map((letter) => (
            <Answer key={letter} result={letter} onAnswer={onAnswer} />
          ))}
          <None onAnswer={onAnswer} />
        </div>
      )}
    </>
  );
}

interface SignsProps {
  names: readonly string[];
  onAnswer(result: string): void;
}

/** A single stop of the Tab key; arrow keys go from sign to sign. Enter answers with the first match. */
function Signs({ names, onAnswer }: SignsProps) {
  const labels = texts.value.capture;
  const query = useSignal("");
  const found = names.filter((name) => folded(name).includes(folded(query.value)));
  const isLong = names.length > MAX_WITHOUT_SEARCH;
  const answerFirst = (event: KeyboardEvent) => {
    if (event.key === "Enter" && query.value.trim() && found[0]) onAnswer(found[0]);
  };
  return (
    <>
      {isLong && (
        <div class="capture__find">
          <input
            type="search"
            class="field"
            aria-label={labels.find}
            placeholder={labels.find}
            autocomplete="off"
            spellcheck={false}
            data-testid="capture-find"
            onInput={(event) => {
              query.value = event.currentTarget.value;
            }}
            onKeyDown={answerFirst}
          />
          <None onAnswer={onAnswer} />
        </div>
      )}
      <fieldset
        class="capture__signs"
        aria-label={labels.signs({ n: found.length })}
        onKeyDown={rove}
      >
        {found.map((name, at) => (
          <Answer key={name} result={name} tabIndex={at === 0 ? 0 : -1} onAnswer={onAnswer} />
        ))}
        {!isLong && <None onAnswer={onAnswer} />}
        {found.length === 0 && <p class="capture__nothing">{labels.nothing}</p>}
      </fieldset>
    </>
  );
}

function folded(text: string): string {
  return text.trim().normalize("NFD").replace(/\p{M}/gu, "").toLowerCase();
}

interface AnswerProps {
  result: string;
  /** Set if only one of several buttons is a stop of the Tab key. */
  tabIndex?: number;
  onAnswer(result: string): void;
}

function Answer({ result, tabIndex, onAnswer }: AnswerProps) {
  return (
    <Button
      class="capture__letter"
      label={namedSign(result, texts.value)}
      testId="capture-letter"
      data-letter={result}
      {...(tabIndex === undefined ? {} : { tabIndex, "data-rove": "" })}
      onPress={() => onAnswer(result)}
    >
      {result}
    </Button>
  );
}

function None({ onAnswer }: Pick<AnswerProps, "onAnswer">) {
  const labels = texts.value.capture;
  return (
    <Button
      class="capture__letter capture__none"
      label={labels.noneHelp}
      testId="capture-letter"
      data-letter=""
      onPress={() => onAnswer("")}
    >
      {labels.none}
    </Button>
  );
}
