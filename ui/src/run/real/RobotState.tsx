import { robotStates } from "./robot_state";
import { stateText } from "./state_text";

interface RobotStateProps {
  link: string;
  testId: string;
}

/** How a watched robot is. A screen reader hears of changes, not of each second. */
export function RobotState({ link, testId }: RobotStateProps) {
  const state = robotStates.value[link];
  const { short, spoken, tip } = stateText(state);
  return (
    <span title={tip} data-testid={testId} data-state={state?.state}>
      <span aria-hidden="true">{short}</span>
      <span class="visually-hidden" role="status">
        {spoken}
      </span>
    </span>
  );
}
