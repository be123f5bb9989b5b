import type { RunPrediction } from "../api/model";
import { language, texts } from "../i18n";
import { isPredictionShown } from "./shown";
import { notesOf, predictionText, robotText } from "./words";

interface PredictionLineProps {
  prediction: RunPrediction;
}

/** A sentence about an ended run beside its prediction. */
export function PredictionLine({ prediction }: PredictionLineProps) {
  if (!isPredictionShown.value) return null;
  const voice = { texts: texts.value, language: language.value };
  return (
    <p
      class="prediction-line row middle gap-2"
      title={notesOf(prediction, voice).join(" ")}
      data-testid="prediction-line"
      data-source={prediction.difference.findings[0]?.source ?? prediction.difference.source}
    >
      <Swatch />
      <span>
        <b>{texts.value.prediction.open}:</b> {predictionText(prediction, voice)}
        <RobotText prediction={prediction} />
      </span>
    </p>
  );
}

/** Which calibrated robot predicts; nothing for the ideal one. */
export function RobotText({ prediction }: PredictionLineProps) {
  const text = robotText(prediction, { texts: texts.value, language: language.value });
  const end = prediction.difference.at_end?.distance_m;
  return (
    text && (
      <span data-testid="prediction-robot" data-within={prediction.within_m} data-off={end}>
        {` ${text}`}
      </span>
    )
  );
}

/** The line style of the predicted path. */
export function Swatch() {
  return (
    <svg class="prediction-swatch" viewBox="0 0 28 6" aria-hidden="true">
      <path d="M2 3h24" />
    </svg>
  );
}
