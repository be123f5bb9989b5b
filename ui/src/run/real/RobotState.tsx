import { robotStates } from "./robot_state";
import { stateText } from "./state_text";

interface RobotStateProps {
  link: string;
  testId: string;
}

/** The state of a watched robot. A screen reader announces changes of the state, not every second. */
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
