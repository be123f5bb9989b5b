import type { RunPrediction } from "../api/model";
import { language, texts } from "../i18n";
import { isPredictionShown } from "./shown";
import { notesOf, predictionText } from "./words";

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
      </span>
    </p>
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
