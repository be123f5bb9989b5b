import { Ghost } from "lucide-preact";
import { texts } from "../i18n";
import { Button } from "../kit/Button";
import { isPredictionShown } from "./shown";

/** Shows or hides the predicted robot. */
export function PredictionSwitch() {
  const { prediction } = texts.value;
  return (
    <Button
      icon={Ghost}
      tip={prediction.hint}
      pressed={isPredictionShown.value}
      testId="prediction-switch"
      onPress={() => {
        isPredictionShown.value = !isPredictionShown.value;
      }}
    >
      {prediction.name}
    </Button>
  );
}
