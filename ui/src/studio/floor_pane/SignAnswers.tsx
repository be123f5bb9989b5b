import { useSignal } from "@preact/signals";
import { drawnHand } from "../../camera/drawn_hand";
import { LETTERS, signNames } from "../../camera/signs";
import { texts } from "../../i18n";
import { namedSign } from "../../i18n/phrases";
import { Button } from "../../kit/Button";
import { listenForKeys } from "../../kit/listen";
import { rove } from "../../kit/roving";
import { Tabs } from "../../kit/Tabs";
import { lazy } from "../../shell/lazy";

const SignDrawing = lazy(async () => (await import("../../camera/SignDrawing")).SignDrawing);

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
            <Answer
              key={letter}
              result={letter}
              isExpected={expected.includes(letter)}
              hasHand
              onAnswer={onAnswer}
            />
          ))}
          <None onAnswer={onAnswer} />
        </div>
      )}
    </>
  );
}

const NUMBERS = Array.from({ length: 11 }, (_, number) => String(number));

/** Calls back if the user presses a digit and no other element has the keyboard focus. */
export function listenForDigits(onAnswer: (result: string) => void): () => void {
  return listenForKeys((key) => {
    const isDigit = /^\d$/.test(key);
    if (isDigit) onAnswer(key);
    return isDigit;
  });
}

/** A button for every number that two hands can show, and for none. */
export function NumberAnswers({ onAnswer }: Pick<SignAnswersProps, "onAnswer">) {
  const labels = texts.value.capture;
  return (
    <>
      <p class="capture__by-hand aside">{labels.byHand}</p>
      <fieldset class="capture__letters" aria-label={labels.numbers}>
        {NUMBERS.map((number) => (
          <Answer key={number} result={number} label={number} onAnswer={onAnswer} />
        ))}
        <None label={labels.noNumber} onAnswer={onAnswer} />
      </fieldset>
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
  /** What is read aloud; by default, what a sign of this name is called. */
  label?: string;
  /** Whether the program compares the answer with it. */
  isExpected?: boolean;
  /** Whether the hand that shows it is drawn above its name. */
  hasHand?: boolean;
  onAnswer(result: string): void;
}

function Answer({ result, tabIndex, label, isExpected, hasHand, onAnswer }: AnswerProps) {
  return (
    <Button
      class="capture__letter"
      label={label ?? namedSign(result, texts.value)}
      testId="capture-letter"
      data-letter={result}
      data-expected={isExpected}
      {...(tabIndex === undefined ? {} : { tabIndex, "data-rove": "" })}
      onPress={() => onAnswer(result)}
    >
      {hasHand && <SignDrawing sign={result} hand={drawnHand.value} />}
      <span>{result}</span>
    </Button>
  );
}

function None({ label, onAnswer }: Pick<AnswerProps, "label" | "onAnswer">) {
  const labels = texts.value.capture;
  return (
    <Button
      class="capture__letter capture__none"
      label={label ?? labels.noneHelp}
      testId="capture-letter"
      data-letter=""
      onPress={() => onAnswer("")}
    >
      {labels.none}
    </Button>
  );
}
