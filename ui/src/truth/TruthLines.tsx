import { useSignal } from "@preact/signals";
import { Ruler } from "lucide-preact";
import type { TruthList } from "../api/model";
import { truthsApi } from "../api/real_runs";
import { language, texts } from "../i18n";
import { Button } from "../kit/Button";
import { useLoaded } from "../kit/requests/useLoaded";
import { SIMULATOR } from "../run/real/real_robot";
import { sourceOfPath } from "./measured_path";
import { TapeForm } from "./TapeForm";
import { truthSentences } from "./words";

interface TruthLinesProps {
  run: string;
  link: string | null;
}

/** Where a real robot truly was at the end of a run, by each source, beside what it believed; nothing of a simulated run. */
export function TruthLines({ run, link }: TruthLinesProps) {
  return link === null || link === SIMULATOR ? null : <LoadedLines run={run} />;
}

function LoadedLines({ run }: { run: string }) {
  const truths = useLoaded(run, () => truthsApi.of(run));
  return truths.status === "ready" ? <Sentences of={truths.value} /> : null;
}

/** With `hasPath` the line of the path on the floor stands before its source. */
function Sentences({ of, hasPath = false }: { of: TruthList; hasPath?: boolean }) {
  const drawn = hasPath ? sourceOfPath(of)?.source : undefined;
  return (
    <>
      {truthSentences(of, texts.value, language.value).map(({ source, text }) => (
        <p key={source} class="truth-line" data-testid="truth-line" data-source={source}>
          {source === drawn && <MeasuredSwatch />}
          {text}
        </p>
      ))}
    </>
  );
}

/** The line style of the measured path. */
function MeasuredSwatch() {
  return (
    <svg class="measured-swatch" viewBox="0 0 28 6" role="img" aria-label={texts.value.truth.path}>
      <path d="M3 3h24" />
    </svg>
  );
}

interface MeasurableRun {
  id: string;
  link: string;
  model: string | null;
}

/** The same with a button that measures later, or measures again. */
export function MeasuredRun({ run }: { run: MeasurableRun }) {
  return run.link === SIMULATOR ? null : <Measurable run={run} />;
}

function Measurable({ run }: { run: MeasurableRun }) {
  const truths = useLoaded(run.id, () => truthsApi.of(run.id));
  const isOpen = useSignal(false);
  const { truth: words } = texts.value;
  if (truths.status !== "ready") return null;
  const isMeasured = truths.value.truths.some(({ source }) => source === "tape");
  return (
    <div class="measured row middle wrap gap-2">
      <div class="measured__lines">
        <Sentences of={truths.value} hasPath />
      </div>
      <Button
        icon={Ruler}
        testId="tape-open"
        open={isOpen.value}
        onPress={() => {
          isOpen.value = !isOpen.value;
        }}
      >
        {isMeasured ? words.change : words.measure}
      </Button>
      {isOpen.value && (
        <TapeForm
          run={run.id}
          model={run.model}
          truths={truths.value}
          onSaved={(saved) => {
            truths.set(saved);
            isOpen.value = false;
          }}
          onClose={() => {
            isOpen.value = false;
          }}
        />
      )}
    </div>
  );
}
