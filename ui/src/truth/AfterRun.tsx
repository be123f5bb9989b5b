import { signal, useSignal } from "@preact/signals";
import { Ruler } from "lucide-preact";
import type { TruthList } from "../api/model";
import { truthsApi } from "../api/real_runs";
import { language, texts } from "../i18n";
import { Button } from "../kit/Button";
import { useLoaded } from "../kit/requests/useLoaded";
import { live, liveRun } from "../run/live";
import { SIMULATOR } from "../run/real/real_robot";
import { followedRun } from "../run/real/truth_sources";
import { isLive } from "../run/reducer";
import { truthChanges } from "./changes";
import { TapeForm } from "./TapeForm";
import { followedSentences, truthSentences } from "./words";

/** Id of the run about which the group has answered or does not want to. */
const skippedRun = signal<string | null>(null);

/** After a run on a real robot, asks where the robot stands; not again for a run that was skipped. */
export function AfterRun() {
  const run = liveRun.value;
  const { moved } = live.value;
  const isOver = !isLive(live.value) && live.value.run === run?.id;
  if (!run || !isOver || !moved || run.link === SIMULATOR || skippedRun.value === run.id)
    return null;
  return <Question key={run.id} run={run.id} model={run.model} />;
}

interface QuestionProps {
  run: string;
  model: string | null;
}

function Question({ run, model }: QuestionProps) {
  const truths = useLoaded([run, truthChanges.value], () => truthsApi.of(run));
  const isMeasuring = useSignal(false);
  const skip = () => {
    skippedRun.value = run;
  };
  if (truths.status !== "ready") return null;
  return (
    <div class={`after-run ${isMeasuring.value ? "" : "after-run--asked"}`}>
      {isMeasuring.value ? (
        <TapeForm
          run={run}
          model={model}
          truths={truths.value}
          onSaved={(saved) => {
            truths.set(saved);
            isMeasuring.value = false;
          }}
          onClose={() => {
            isMeasuring.value = false;
          }}
        />
      ) : (
        <Asked
          run={run}
          truths={truths.value}
          onMeasure={() => {
            isMeasuring.value = true;
          }}
          onSkip={skip}
        />
      )}
    </div>
  );
}

interface AskedProps {
  run: string;
  truths: TruthList;
  onMeasure(): void;
  onSkip(): void;
}

/** The question, or what was measured. */
function Asked({ run, truths, onMeasure, onSkip }: AskedProps) {
  const { truth: words } = texts.value;
  const sentences = truthSentences(truths, texts.value, language.value);
  return (
    <section class="after-run__asked card column gap-2" data-testid="after-run">
      <h2 class="tape__title">{words.title}</h2>
      {sentences.length === 0 && <p>{words.ask}</p>}
      {sentences.map(({ source, text }) => (
        <p key={source} data-testid="truth-line" data-source={source}>
          {text}
        </p>
      ))}
      <Followed run={run} />
      <div class="row wrap gap-2">
        <Button icon={Ruler} testId="tape-open" onPress={onMeasure}>
          {sentences.length > 0 ? words.change : words.measure}
        </Button>
        <Button kind="plain" testId="tape-skip" onPress={onSkip}>
          {sentences.length > 0 ? words.done : words.skip}
        </Button>
      </div>
    </section>
  );
}

/** What went wrong with the sources that followed the robot in this run. */
function Followed({ run }: { run: string }) {
  return (
    <>
      {followedSentences(followedRun(run).value, texts.value).map((text) => (
        <p key={text} data-testid="followed-line">
          {text}
        </p>
      ))}
    </>
  );
}
