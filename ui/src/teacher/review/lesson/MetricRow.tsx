import { CircleQuestionMark } from "lucide-preact";
import type { Figures, OpenedHints } from "../../../api/model";
import { language, texts } from "../../../i18n";
import { hintsRead, labelled } from "../../../i18n/phrases";
import { Button } from "../../../kit/Button";
import { rove } from "../../../kit/roving";
import { roundDuration } from "../../time_format";
import { metricText } from "../metric_text";
import type { MetricName } from "../model";
import { hideTip, showTip } from "../timeline_entries/tip";

export const METRICS: readonly MetricName[] = [
  "n_edits",
  "n_runs",
  "n_failed",
  "time_to_first_run_s",
  "attempts_until_passed",
  "n_hints",
  "active_s",
];

interface MetricRowProps {
  group: string;
  metrics: Figures;
  hints: readonly OpenedHints[];
}

/** The metrics of a group, each with a tooltip that explains it. */
export function MetricRow({ group, metrics, hints }: MetricRowProps) {
  const labels = texts.value.review.figures;
  return (
    <ul class="figures" aria-label={labels.label({ group })} onKeyDown={rove}>
      {METRICS.map((name, index) => (
        <li key={name}>
          <Metric
            name={name}
            value={metrics[name]}
            first={index === 0}
            more={name === "n_hints" ? hintLines(hints) : []}
          />
        </li>
      ))}
    </ul>
  );
}

interface MetricProps {
  name: MetricName;
  value: number | null;
  first: boolean;
  /** Further lines of the tooltip: the counted items. */
  more: readonly string[];
}

function Metric({ name, value, first, more }: MetricProps) {
  const labels = texts.value.review.figures;
  const shown = value === null ? labels.unknown : valueText(name, value);
  const unit = labels[name]({ count: value ?? 0 });
  const show = (event: { currentTarget: HTMLElement }) =>
    showTip(event.currentTarget, () => {
      const { message, remedy } = metricText(name);
      return { title: message, lines: [...more, remedy] };
    });
  return (
    <Button
      kind="bare"
      class="figure aside"
      tabIndex={first ? 0 : -1}
      data-rove
      testId="review-figure"
      data-name={name}
      data-value={value ?? ""}
      label={labels.ask({ figure: `${shown} ${unit}` })}
      onPress={show}
      onMouseEnter={show}
      onFocus={show}
      onMouseLeave={(event) => hideTip(event.currentTarget)}
      onBlur={(event) => hideTip(event.currentTarget)}
    >
      <b>{shown}</b> {unit}
      <CircleQuestionMark class="icon figure__ask" aria-hidden="true" />
    </Button>
  );
}

/** Lines about the opened hints of each activity. */
function hintLines(hints: readonly OpenedHints[]): string[] {
  return hints.map(({ title, n }) => `${labelled(title, hintsRead(n, texts.value))}.`);
}

function valueText(name: MetricName, value: number): string {
  return name.endsWith("_s") ? roundDuration(value, language.value) : String(value);
}
