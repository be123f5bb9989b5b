import { Bot } from "lucide-preact";
import { texts } from "../../i18n";
import { labelled } from "../../i18n/phrases";
import { Select } from "../../kit/Select";
import * as robot from "../../run/live";
import { robotLabel } from "../../run/real/RobotName";
import { chooseRobot, chosenRobot, realRobots, SIMULATOR } from "../../run/real/real_robot";
import { robotStates } from "../../run/real/robot_state";
import { stateText } from "../../run/real/state_text";
import { isLive } from "../../run/reducer";

/** The simulator or a real robot; shown if the teacher has set one up. */
export function RobotChoice() {
  const { robot: labels } = texts.value;
  const ready = realRobots.value.filter((one) => one.is_set_up);
  if (ready.length === 0) return null;
  const chosen = chosenRobot.value?.link;
  return (
    <Select
      icon={Bot}
      label={labels.choice}
      tip={
        chosen ? labelled(labels.choice, stateText(robotStates.value[chosen]).short) : labels.choice
      }
      testId="robot-choice"
      value={chosen ?? SIMULATOR}
      options={[
        [SIMULATOR, labels.simulator],
        ...ready.map(({ link }) => [link, robotLabel(link)] as const),
      ]}
      disabled={isLive(robot.live.value)}
      onChange={(link) => {
        chooseRobot(link);
        robot.clear();
      }}
    />
  );
}
