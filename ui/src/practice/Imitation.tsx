import type { Signal } from "@preact/signals";
import { CircleCheck, CircleQuestionMark } from "lucide-preact";
import { useLayoutEffect } from "preact/hooks";
import { drawnHand } from "../camera/drawn_hand";
import type { HandSide } from "../camera/hand_shape";
import { SignDrawing } from "../camera/SignDrawing";
import { sight } from "../camera/sight";
import { signStateOf } from "../camera/sign_state";
import { listenForSigns, signNames } from "../camera/signs";
import { texts } from "../i18n";
import { namedSign } from "../i18n/phrases";
import { RadioGroup } from "../kit/RadioGroup";

/** Exercise: shows the drawing of a letter, and whether the camera detects this letter now. */
export function Imitation({ letter }: { letter: Signal<string> }) {
  const { practice } = texts.value;
  const choose = (chosen: string) => {
    letter.value = chosen;
  };
  useLayoutEffect(() => listenForSigns(choose), []);
  const state = signStateOf(sight.value);
  const isMatched = state.kind === "sure" && state.best === letter.value;
  return (
    <section
      class="imitation card grows shrinks-down"
      aria-label={practice.imitate}
      data-matched={String(isMatched)}
    >
      <div class="column shrinks-down">
        <h2 class="imitation__title">{practice.imitate}</h2>
        <SignDrawing sign={letter.value} hand={drawnHand.value} class="grows shrinks-down" />
        <Outcome letter={letter.value} shown={state.kind === "sure" ? state.best : null} />
      </div>
      <div class="imitation__choices column shrinks-down gap-3">
        <RadioGroup
          label={practice.choose}
          class="imitation__letters"
          optionClass="imitation__letter"
          testId="practice-sign"
          value={letter.value}
          options={signNames.value.map(option)}
          onChange={choose}
        />
        <RadioGroup
          label={practice.hand}
          legendClass="imitation__legend"
          class="imitation__hands"
          testId="practice-hand"
          value={drawnHand.value}
          options={[
            ["left", practice.left],
            ["right", practice.right],
          ]}
          onChange={(side: HandSide) => {
            drawnHand.value = side;
          }}
        />
      </div>
    </section>
  );
}

const option = (name: string) =>
  [name, name, { "data-letter": name, "data-long": String(name.length > 1) }] as const;

/** Whether the camera sees the letter, or which other sign it sees instead. */
function Outcome({ letter, shown }: { letter: string; shown: string | null }) {
  const { matched, other } = texts.value.practice;
  const isMatched = shown === letter;
  const Icon = isMatched ? CircleCheck : CircleQuestionMark;
  const sign = (name: string) => namedSign(name, texts.value);
  return (
    <p class="imitation__outcome row middle gap-2" role="status">
      {shown && (
        <>
          <Icon class="icon" aria-hidden="true" />
          {isMatched
            ? matched({ sign: sign(letter) })
            : other({ sign: sign(letter), shown: sign(shown) })}
        </>
      )}
    </p>
  );
}
