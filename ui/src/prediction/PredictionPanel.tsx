import type { Finding, RunPrediction } from "../api/model";
import { language, texts } from "../i18n";
import { Button } from "../kit/Button";
import { RobotText } from "./PredictionLine";
import { type DifferenceRow, rowsOf } from "./rows";
import { angle, commandText, length, notesOf, predictionText } from "./words";

interface PredictionPanelProps {
  prediction: RunPrediction;
  /** Shows the moment at which a block began. */
  onTick(tick: number): void;
}

/** A run beside its prediction: a sentence, the end, the path error, and each block. */
export function PredictionPanel({ prediction, onTick }: PredictionPanelProps) {
  const { prediction: words } = texts.value;
  const voice = { texts: texts.value, language: language.value };
  const marked = prediction.difference.findings[0];
  return (
    <section class="prediction card column gap-2" aria-label={words.label} data-testid="prediction">
      <p class="prediction__sentence">{predictionText(prediction, voice)}</p>
      {prediction.robot !== null && (
        <p>
          <RobotText prediction={prediction} />
        </p>
      )}
      <Whole prediction={prediction} />
      <table class="prediction__table">
        <caption>{words.by({ source: words.sources[prediction.difference.source] })}</caption>
        <thead>
          <tr>
            <th scope="col">{words.block}</th>
            <th scope="col">{words.predicted}</th>
            <th scope="col">{words.measured}</th>
            <th scope="col">{words.difference}</th>
          </tr>
        </thead>
        <tbody>
          {rowsOf(prediction.difference.steps).map((row) => (
            <Row
              key={`${row.block} ${row.tick}`}
              row={row}
              marked={row.action === marked?.action && row.amount === marked.amount ? marked : null}
              onTick={onTick}
            />
          ))}
        </tbody>
      </table>
      {notesOf(prediction, voice).map((note) => (
        <p key={note} class="aside">
          {note}
        </p>
      ))}
    </section>
  );
}

/** The end of the run, and the error of its path. */
function Whole({ prediction: { difference } }: Pick<PredictionPanelProps, "prediction">) {
  const { prediction: words } = texts.value;
  const { at_end: end, ate_m: ate } = difference;
  return (
    <ul class="prediction__whole row gap-4">
      {end && (
        <li data-testid="prediction-end">
          {words.atEnd({
            distance: length(end.distance_m, language.value),
            heading: angle(Math.abs(end.heading_deg), language.value),
            source: words.sources[end.source],
          })}
        </li>
      )}
      {ate !== null && (
        <li title={words.ateHint} data-testid="prediction-ate">
          {words.ate({
            ate: length(ate, language.value),
            source: words.sources[difference.source],
          })}
        </li>
      )}
    </ul>
  );
}

interface RowProps {
  row: DifferenceRow;
  /** The difference that the sentence is about, if it is that of this row. */
  marked: Finding | null;
  onTick(tick: number): void;
}

function Row({ row, marked, onTick }: RowProps) {
  const { prediction: words } = texts.value;
  const show = row.kind === "turn" ? angle : length;
  const value = (amount: number | null) => (amount === null ? "–" : show(amount, language.value));
  const signed = (by: number) => `${by > 0 ? "+" : ""}${show(by, language.value)}`;
  const off = row.measured === null || row.kind === null ? null : row.measured - row.predicted;
  const name = commandText(row, { texts: texts.value, language: language.value });
  return (
    <tr data-marked={marked !== null} data-testid="prediction-row">
      <th scope="row">
        <Button
          kind="plain"
          class="prediction__command"
          tip={words.showTip}
          onPress={() => onTick(row.tick)}
        >
          {name}
        </Button>
        {row.n > 1 && <span class="aside"> {words.times({ n: row.n })}</span>}
      </th>
      <td>{value(row.kind && row.predicted)}</td>
      <td>{value(row.kind && row.measured)}</td>
      <td>
        {off === null ? "–" : signed(off)}
        {marked?.how === "average" && (
          <span class="prediction__truth">
            {signed(Math.sign(row.predicted) * marked.difference)} {words.sources[marked.source]}
          </span>
        )}
      </td>
    </tr>
  );
}
