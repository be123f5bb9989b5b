import {
  ArrowDown,
  ArrowUp,
  ChevronsUp,
  CircleQuestionMark,
  Clock,
  Crosshair,
  Hand,
  Hourglass,
  type LucideIcon,
  MapPin,
  MessageCircle,
  Pencil,
  RotateCcw,
  RotateCw,
  Spline,
  Square,
} from "lucide-preact";
import { CATEGORY_COLOURS } from "../../blocks/categories";
import { categoryOf } from "../../blocks/definitions";
import { texts } from "../../i18n";
import { coarse, type Stretch } from "../playback";
import type { CaptureAnswer } from "../reducer";
import { CaptureMarks } from "./CaptureMarks";

/** A stretch narrower than this fraction of the slider is too small for an icon. */
const LEGIBLE_PART = 0.035;

const ICONS: Record<string, LucideIcon> = {
  move_forward: ArrowUp,
  move_backward: ArrowDown,
  stop: Square,
  wait: Clock,
  classify_gestures: Hand,
  read_number: Hand,
  set_gesture_result: Pencil,
  arc: Spline,
  go_to: MapPin,
  go_to_place: MapPin,
  drive: ChevronsUp,
  wait_until: Hourglass,
  ask: CircleQuestionMark,
  say: MessageCircle,
  mark: Crosshair,
};

function iconOf({ action, amount }: Stretch): LucideIcon | null {
  if (action === "turn") return (amount ?? 0) < 0 ? RotateCw : RotateCcw;
  return ICONS[action] ?? null;
}

interface TimeStripProps {
  /** The stretches of each run that is shown. */
  tracks: readonly (readonly Stretch[])[];
  tick: number;
  /** The last tick. */
  end: number;
  /** The tick as a text, for screen readers. */
  time: string;
  testId: string;
  /** What captures of the run got. */
  answers?: readonly CaptureAnswer[] | undefined;
  onTick(tick: number): void;
  /** A mark of these answers was pressed. */
  onAnswers?(answers: readonly CaptureAnswer[]): void;
  /** Handles keys that a slider does not use; returns true if it used the key. */
  onKey?(key: string): boolean;
}

/** The time of a run, coloured by block: a press, a drag or a key selects a tick. */
export function TimeStrip(props: TimeStripProps) {
  const { tracks, tick, end, time, testId, onTick, onKey, answers = [], onAnswers } = props;
  const { replay } = texts.value;
  const length = Math.max(1, end);
  return (
    <div class="slider">
      {tracks.map((stretches, index) => (
        <div
          key={index}
          class={`slider__track ${tracks.length > 1 ? `slider__track--half slider__track--${index}` : ""}`}
          aria-hidden="true"
        >
          <Stretches stretches={stretches} end={length} />
        </div>
      ))}
      <input
        type="range"
        class="slider__input"
        min="0"
        max={end}
        step="1"
        value={Math.floor(tick)}
        aria-label={replay.slider}
        aria-valuetext={time}
        data-testid={testId}
        style={{ "--at": `${(100 * tick) / length}%` }}
        onInput={(event) => onTick(event.currentTarget.valueAsNumber)}
        onKeyDown={(event) => {
          if (onKey?.(event.key)) event.preventDefault();
        }}
      />
      {answers.length > 0 && onAnswers && (
        <CaptureMarks answers={answers} end={end} onAnswers={onAnswers} />
      )}
      <output class="slider__time aside" aria-hidden="true">
        {time}
      </output>
    </div>
  );
}

function Stretches({ stretches, end }: { stretches: readonly Stretch[]; end: number }) {
  return (
    <>
      {coarse(stretches, end).map((stretch) => {
        const { from, to, action } = stretch;
        const part = (to - from) / end;
        const Icon = part > LEGIBLE_PART ? iconOf(stretch) : null;
        return (
          <span
            key={`${from}/${action}`}
            class="slider__stretch"
            style={{
              left: `${(100 * from) / end}%`,
              width: `${100 * part}%`,
              background: CATEGORY_COLOURS[categoryOf(action)],
            }}
          >
            {Icon && <Icon class="icon" />}
          </span>
        );
      })}
    </>
  );
}
