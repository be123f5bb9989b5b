import { Pause, Play, RotateCcw, StepBack, StepForward } from "lucide-preact";
import { useLayoutEffect } from "preact/hooks";
import { language, texts } from "../i18n";
import { decimal, duration } from "../i18n/format";
import { Button } from "../kit/Button";
import { listen } from "../kit/listen";
import { Select } from "../kit/Select";
import { TimeStrip } from "../run/panels/TimeStrip";
import { inOrder, type Playback, SPEEDS, type Stretch, stepFrom } from "../run/playback";
import type { CaptureAnswer } from "../run/reducer";

interface PlaybackControlsProps {
  playback: Playback;
  /** The stretches of each displayed run. */
  tracks: readonly (readonly Stretch[])[];
  /** What captures of the run got. */
  answers?: readonly CaptureAnswer[] | undefined;
}

/** Controls of a replay: play, step by block, speed, and the slider coloured by block. */
export function PlaybackControls({ playback, tracks, answers }: PlaybackControlsProps) {
  const { replay } = texts.value;
  const step = (direction: -1 | 1) => {
    playback.pause();
    playback.seek(stepFrom(inOrder(tracks), playback.tick.value, direction, playback.end));
  };
  useLayoutEffect(() => listenToKeys(() => playback.toggle(), step), [playback]);
  return (
    <section class="transport row middle gap-3" aria-label={replay.title}>
      <PlayButton playback={playback} />
      <div class="transport__steps row gap-1">
        <Button icon={StepBack} label={replay.back} testId="replay-back" onPress={() => step(-1)} />
        <Button
          icon={StepForward}
          label={replay.forward}
          testId="replay-forward"
          onPress={() => step(1)}
        />
      </div>
      <Slider playback={playback} tracks={tracks} answers={answers} />
      <Speed playback={playback} />
    </section>
  );
}

function PlayButton({ playback }: { playback: Playback }) {
  const { replay } = texts.value;
  const playing = playback.playing.value;
  const over = !playing && playback.end > 0 && playback.tick.value >= playback.end;
  const Icon = playing ? Pause : over ? RotateCcw : Play;
  return (
    <Button
      icon={Icon}
      filled={!over}
      kind="main"
      class="transport__play"
      testId="replay-play"
      data-does={playing ? "pause" : "play"}
      onPress={() => playback.toggle()}
    >
      {playing ? replay.pause : over ? replay.again : replay.play}
    </Button>
  );
}

function Slider({ playback, tracks, answers }: PlaybackControlsProps) {
  const { replay } = texts.value;
  const time = (tick: number) => duration(tick / 30, language.value);
  return (
    <TimeStrip
      tracks={tracks}
      tick={playback.tick.value}
      end={playback.end}
      time={replay.at({ now: time(playback.tick.value), end: time(playback.end) })}
      testId="replay-slider"
      answers={answers}
      onAnswers={(some) => playback.showAnswers(some)}
      onTick={(tick) => playback.seek(tick)}
    />
  );
}

function Speed({ playback }: { playback: Playback }) {
  const { replay } = texts.value;
  return (
    <Select
      class="transport__speed"
      label={replay.speed}
      tip={replay.speed}
      testId="replay-speed"
      value={playback.speed.value}
      options={SPEEDS.map((speed) => [speed, `${speedText(speed)}×`])}
      onChange={(speed) => {
        playback.speed.value = speed;
      }}
    />
  );
}

const speedText = (speed: number) =>
  decimal(speed, speed < 0.5 ? 2 : speed < 1 ? 1 : 0, language.value);

/** Space plays or pauses, arrow keys step, unless the focused element uses these keys. */
function listenToKeys(toggle: () => void, step: (direction: -1 | 1) => void): () => void {
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
