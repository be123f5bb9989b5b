import { Ghost } from "lucide-preact";
import { texts } from "../i18n";
import { Button } from "../kit/Button";
import { isPredictionShown } from "./shown";

/** Shows or hides the predicted robot; `isSmall` in a corner with much else. */
export function PredictionSwitch({ isSmall = false }: { isSmall?: boolean }) {
  const { prediction } = texts.value;
  return (
    <Button
      icon={Ghost}
      label={isSmall ? prediction.name : undefined}
      tip={prediction.hint}
      pressed={isPredictionShown.value}
      testId="prediction-switch"
      onPress={() => {
        isPredictionShown.value = !isPredictionShown.value;
      }}
    >
      {!isSmall && prediction.name}
    </Button>
  );
}
