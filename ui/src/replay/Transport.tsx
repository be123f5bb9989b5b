import {
  ArrowDown,
  ArrowUp,
  ChevronsUp,
  CircleQuestionMark,
  Clock,
  Crosshair,
  Hand,
  Hourglass,
  MapPin,
  MessageCircle,
  Pause,
  Pencil,
  Play,
  RotateCcw,
  RotateCw,
  Spline,
  Square,
  StepBack,
  StepForward,
} from "lucide-preact";
import { useLayoutEffect } from "preact/hooks";
import { CATEGORY_COLOURS } from "../blocks/categories";
import { categoryOf } from "../blocks/definitions";
import { language, texts } from "../i18n";
import { decimal, duration } from "../i18n/format";
import { Button } from "../kit/Button";
import { listen } from "../kit/listen";
import { Select } from "../kit/Select";
import { coarse, type Playback, SPEEDS, type Stretch, stepFrom } from "../run/playback";
import { TEST } from "../shell/testids";

/** A stretch narrower than this fraction of the slider has no room for an icon. */
const LEGIBLE_PART = 0.035;

const ICONS: Record<string, typeof Play> = {
  move_forward: ArrowUp,
  move_backward: ArrowDown,
  stop: Square,
  wait: Clock,
  classify_gestures: Hand,
  set_gesture_result: Pencil,
  arc: Spline,
  go_to: MapPin,
  drive: ChevronsUp,
  wait_until: Hourglass,
  ask: CircleQuestionMark,
  say: MessageCircle,
  mark: Crosshair,
};

function iconOf({ action, amount }: Stretch): typeof Play | null {
  if (action === "turn") return (amount ?? 0) < 0 ? RotateCw : RotateCcw;
  return ICONS[action] ?? null;
}

interface TransportProps {
  playback: Playback;
  /** The stretches of each run that is shown. */
  tracks: readonly (readonly Stretch[])[];
}

/** Controls of a replay: play, step by block, speed, and the slider coloured by block. */
export function Transport({ playback, tracks }: TransportProps) {
  const { replay } = texts.value;
  const step = (way: -1 | 1) => {
    playback.pause();
    playback.seek(stepFrom(inOrder(tracks), playback.tick.value, way, playback.end));
  };
  useLayoutEffect(() => listenToKeys(() => playback.toggle(), step), [playback]);
  return (
    <section class="transport" aria-label={replay.title}>
      <PlayButton playback={playback} />
      <div class="transport__steps">
        <Button
          icon={StepBack}
          label={replay.back}
          testId={TEST.replayBack}
          onPress={() => step(-1)}
        />
        <Button
          icon={StepForward}
          label={replay.forward}
          testId={TEST.replayForward}
          onPress={() => step(1)}
        />
      </div>
      <Slider playback={playback} tracks={tracks} />
      <Speed playback={playback} />
    </section>
  );
}

function PlayButton({ playback }: { playback: Playback }) {
  const { replay } = texts.value;
  const playing = playback.playing.value;
  const over = !playing && playback.tick.value >= playback.end;
  const Icon = playing ? Pause : over ? RotateCcw : Play;
  return (
    <Button
      icon={Icon}
      filled={!over}
      kind="main"
      class="transport__play"
      testId={TEST.replayPlay}
      data-does={playing ? "pause" : "play"}
      onPress={() => playback.toggle()}
    >
      {playing ? replay.pause : over ? replay.again : replay.play}
    </Button>
  );
}

function Slider({ playback, tracks }: TransportProps) {
  const { replay } = texts.value;
  const end = Math.max(1, playback.end);
  const time = (tick: number) => duration(tick / 30, language.value);
  const said = replay.at(time(playback.tick.value), time(playback.end));
  return (
    <div class="slider">
      {tracks.map((stretches, index) => (
        <div
          key={index}
          class={`slider__track ${tracks.length > 1 ? `slider__track--half slider__track--${index}` : ""}`}
          aria-hidden="true"
        >
          <Stretches stretches={stretches} end={end} />
        </div>
      ))}
      <input
        type="range"
        class="slider__input"
        min="0"
        max={playback.end}
        step="1"
        value={Math.floor(playback.tick.value)}
        aria-label={replay.slider}
        aria-valuetext={said}
        data-testid={TEST.replaySlider}
        style={{ "--at": `${(100 * playback.tick.value) / end}%` }}
        onInput={(event) => playback.seek(event.currentTarget.valueAsNumber)}
      />
      <output class="slider__time" aria-hidden="true">
        {said}
      </output>
    </div>
  );
}

/** The blocks of all runs, ordered by their start. */
function inOrder(tracks: TransportProps["tracks"]): readonly Stretch[] {
  const [only, ...others] = tracks;
  return only && others.length === 0 ? only : tracks.flat().sort((a, b) => a.from - b.from);
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

function Speed({ playback }: { playback: Playback }) {
  const { replay } = texts.value;
  return (
    <Select
      class="transport__speed"
      label={replay.speed}
      tip={replay.speed}
      testId={TEST.replaySpeed}
      value={playback.speed.value}
      options={SPEEDS.map((speed) => [speed, `${speedWords(speed)}×`])}
      onChange={(speed) => {
        playback.speed.value = speed;
      }}
    />
  );
}

const speedWords = (speed: number) =>
  decimal(speed, speed < 0.5 ? 2 : speed < 1 ? 1 : 0, language.value);

/** Space plays, arrow keys step, unless the focus is in a field that uses these keys. */
function listenToKeys(toggle: () => void, step: (way: -1 | 1) => void): () => void {
  const onKey = (event: KeyboardEvent) => {
    const target = event.target as HTMLElement;
    if (target.closest("input, select, button, a, textarea, .injectionDiv")) {
      if (event.key !== " " || target.closest("button, select, a, .injectionDiv")) return;
    }
    if (event.key === " ") toggle();
    else if (event.key === "ArrowLeft") step(-1);
    else if (event.key === "ArrowRight") step(1);
    else return;
    event.preventDefault();
  };
  return listen(window, { keydown: onKey });
}
