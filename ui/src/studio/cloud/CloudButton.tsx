import { Waypoints } from "lucide-preact";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { chosenRobot } from "../../run/real/real_robot";
import { isLivePhase } from "../../run/reducer";
import type { ActionsProps } from "../run_bar/ActionButton";

/** Drives the program in 50 realistic robots at once. */
export function CloudButton({ control, state }: ActionsProps) {
  const { cloud } = texts.value;
  const { isUnderWay } = control.cloud;
  const isReal = chosenRobot.value !== null;
  return (
    <Button
      class="run-bar__cloud"
      icon={Waypoints}
      tip={isReal ? cloud.notReal : cloud.tip}
      testId="cloud"
      disabled={isReal || isLivePhase(state.phase) || isUnderWay.value}
      onPointerEnter={() => control.cloud.warmUp()}
      onFocus={() => control.cloud.warmUp()}
      onPress={() => control.startCloud()}
    >
      {cloud.button}
    </Button>
  );
}
