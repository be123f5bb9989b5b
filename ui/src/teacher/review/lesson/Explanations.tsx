import { language, texts } from "../../../i18n";
import { metricText } from "../metric_text";
import { METRICS } from "./MetricRow";

/** Explains each metric on the printed page, which has no tooltips. */
export function Explanations() {
  const { lesson: labels } = texts.value.review;
  const now = new Date().toLocaleString(language.value, { dateStyle: "long", timeStyle: "short" });
  return (
    <section class="lesson__explained aside" data-testid="lesson-explained">
      <h2>{labels.counts}</h2>
      <p>{labels.noRanking}</p>
      <dl>
        {[...METRICS, "blocks", "repairs"].map((name) => {
          const { message, remedy } = metricText(name);
          return (
            <div key={name}>
              <dt>{message}</dt>
              <dd>{remedy}</dd>
            </div>
          );
        })}
      </dl>
      <p>{labels.printed({ date: now })}</p>
    </section>
  );
}
