import { CircleQuestionMark, Hand, type LucideIcon } from "lucide-preact";
import { language, type Texts, texts } from "../i18n";
import { percent } from "../i18n/format";
import type { SignState } from "./sign_state";

/** Radius of the ring around the letter; its circumference is 100. */
const RADIUS = 50 / Math.PI;

/** What is said of each state: a sign is looked for, or a number. */
export interface StateLabels
  extends Pick<
    Texts["camera"],
    "unsure" | "either" | "noLetter" | "twoSigns" | "showHand" | "hold"
  > {
  /** What the recognised sign or number is called. */
  called(best: string): string;
}

interface SignStateViewProps {
  state: SignState;
  labels: StateLabels;
  /** Fraction of the hold time that has passed, 0 to 1. */
  progress: number;
  /** Instruction while a sign is held. */
  next: string;
}

/** The detected sign, its confidence, and the progress of its hold time. */
export function SignStateView({ state, labels, progress, next }: SignStateViewProps) {
  const { steady } = texts.value.camera;
  const whole = Math.round(100 * progress);
  return (
    <div class="reading row middle shrinks gap-3" data-testid="reading" data-kind={state.kind}>
      <div
        class="reading__ring"
        role="progressbar"
        aria-label={steady}
        aria-valuenow={whole}
        aria-valuemin={0}
        aria-valuemax={100}
      >
        <svg viewBox="0 0 36 36" aria-hidden="true">
          <circle class="reading__track" cx="18" cy="18" r={RADIUS} />
          <circle
            class="reading__done"
            cx="18"
            cy="18"
            r={RADIUS}
            stroke-dasharray={`${whole} ${100 - whole}`}
          />
        </svg>
        <Middle state={state} />
      </div>
      <StateText state={state} labels={labels} next={progress > 0 ? next : null} />
    </div>
  );
}

const ICONS: Partial<Record<SignState["kind"], LucideIcon>> = {
  "no letter": CircleQuestionMark,
  unsure: CircleQuestionMark,
};

function Middle({ state }: { state: SignState }) {
  if (state.kind === "sure") {
    return <span class={`reading__letter ${long(state.best)}`}>{state.best}</span>;
  }
  const Icon = ICONS[state.kind] ?? Hand;
  return <Icon class="icon reading__icon" aria-hidden="true" />;
}

/** CSS class for the name of a taught sign, which may have several letters. */
const long = (sign: string) => (sign.length > 1 ? "reading__letter--long" : "");

interface StateTextProps {
  state: SignState;
  labels: StateLabels;
  next: string | null;
}

function StateText({ state, labels: camera, next }: StateTextProps) {
  switch (state.kind) {
    case "sure":
      return <Sure {...state} name={camera.called(state.best)} next={next} />;
    case "unsure":
      return (
        <p class="reading__words">
          <span>{camera.unsure}</span>
          <strong class="reading__doubt">
            {state.second
              ? camera.either({ one: state.best, other: state.second })
              : `${state.best}?`}
          </strong>
        </p>
      );
    case "no letter":
      return <p class="reading__words">{camera.noLetter}</p>;
    case "two signs":
      return <p class="reading__words">{camera.twoSigns}</p>;
    default:
      return <p class="reading__words">{camera.showHand}</p>;
  }
}

interface SureProps {
  name: string;
  second: string;
  confidence: number;
  next: string | null;
}

function Sure({ name, second, confidence, next }: SureProps) {
  const { camera } = texts.value;
  const share = percent(confidence, language.value);
  return (
    <div class="reading__words">
      <p class="visually-hidden">{camera.sure({ sign: name, share })}</p>
      <div class="row middle gap-2" aria-hidden="true">
        <span class="reading__bar">
          <span style={{ width: `${100 * confidence}%` }} />
        </span>
        <span class="reading__share">{share}</span>
      </div>
      <p class="reading__second">{next ?? (second && camera.orElse({ letter: second }))}</p>
    </div>
  );
}
