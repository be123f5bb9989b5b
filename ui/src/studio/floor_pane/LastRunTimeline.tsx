import { Film } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { language, texts } from "../../i18n";
import { duration } from "../../i18n/format";
import { LinkButton } from "../../kit/LinkButton";
import { listen } from "../../kit/listen";
import { inspectedTick, inspectTick } from "../../run/inspected_tick";
import { captureShow, live } from "../../run/live";
import { record } from "../../run/live_record";
import { TimeStrip } from "../../run/panels/TimeStrip";
import { stepFrom } from "../../run/playback";
import { SaveRunImage } from "../../run_image/SaveRunImage";
import { hashOf } from "../../shell/route";

const DIRECTIONS: Readonly<Record<string, -1 | 1>> = { ArrowLeft: -1, ArrowRight: 1 };

/** Time strip of the last run: shows a chosen tick on the floor and in the blocks, until the group leaves it. */
export function LastRunTimeline() {
  useEffect(returnsToEnd, []);
  const { work, replay } = texts.value;
  const { run } = live.value;
  if (!run) return null;
  return (
    <section
      class="past-run row middle grows shrinks gap-2"
      aria-label={texts.value.run.time}
      data-testid="past-run"
    >
      {record.isWhole && <Strip />}
      <LinkButton
        icon={Film}
        tip={replay.title}
        href={hashOf({ screen: "replay", run })}
        testId="past-run-replay"
      >
        {work.replay}
      </LinkButton>
      <SaveRunImage runId={run} opens="above" />
    </section>
  );
}

function Strip() {
  record.revision.value; // subscribes: the last samples may arrive after the end of the run
  const { lastTick: end, stretches, captures } = record;
  const tick = inspectedTick.value?.tick ?? end;
  const time = (ticks: number) => duration(ticks / 30, language.value);
  const step = (key: string) => {
    const direction = DIRECTIONS[key];
    if (direction) inspectTick(stepFrom(stretches, tick, direction, end));
    return direction !== undefined;
  };
  return (
    <div class="grows shrinks" title={texts.value.run.timeHelp}>
      <TimeStrip
        tracks={[stretches]}
        tick={tick}
        end={end}
        time={texts.value.replay.at({ now: time(tick), end: time(end) })}
        testId="past-run-slider"
        answers={captures}
        onTick={inspectTick}
        onAnswers={(answers) => {
          inspectTick(answers[0]?.tick ?? null);
          captureShow.start(answers);
        }}
        onKey={step}
      />
    </div>
  );
}

/** Shows the end of the run again: at a press or focus outside the floor's pane, at Escape, at unmount. */
function returnsToEnd(): () => void {
  const leave = ({ target }: Event) => {
    if (target instanceof Element && !target.closest(".floor")) inspectTick(null);
  };
  const stop = listen(
    window,
    {
      pointerdown: leave,
      focusin: leave,
      keydown: ({ key }) => key === "Escape" && inspectTick(null),
    },
    { capture: true },
  );
  return () => {
    stop();
    inspectTick(null);
  };
}
