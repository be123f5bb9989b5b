import { Ghost } from "lucide-preact";
import { texts } from "../i18n";
import { Button } from "../kit/Button";
import { isPredictionShown } from "./shown";

interface PredictionSwitchProps {
  /** In a corner with much else. */
  isSmall?: boolean;
  /** Name of the calibrated robot that predicts; null for the ideal one. */
  robot?: string | null | undefined;
}

/** Shows or hides the predicted robot. */
export function PredictionSwitch({ isSmall = false, robot }: PredictionSwitchProps) {
  const { prediction } = texts.value;
  return (
    <Button
      icon={Ghost}
      label={isSmall ? prediction.name : undefined}
      tip={robot ? `${prediction.hint} ${prediction.robot({ robot })}` : prediction.hint}
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
