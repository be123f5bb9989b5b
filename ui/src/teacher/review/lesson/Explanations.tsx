import { language, texts } from "../../../i18n";
import { figureWords } from "../words";
import { FIGURES } from "./FigureRow";

/** Explains each figure on the printed page, which has no tooltips. */
export function Explanations() {
  const { lesson: say } = texts.value.review;
  const now = new Date().toLocaleString(language.value, { dateStyle: "long", timeStyle: "short" });
  return (
    <section class="lesson__explained aside" data-testid="lesson-explained">
      <h2>{say.counts}</h2>
      <p>{say.noRanking}</p>
      <dl>
        {[...FIGURES, "blocks", "repairs"].map((name) => {
          const { message, remedy } = figureWords(name);
          return (
            <div key={name}>
              <dt>{message}</dt>
              <dd>{remedy}</dd>
            </div>
          );
        })}
      </dl>
      <p>{say.printed(now)}</p>
    </section>
  );
}
