import { Bot } from "lucide-preact";
import { texts } from "../../i18n";
import { Select } from "../../kit/Select";
import * as robot from "../../run/live";
import { robotWords } from "../../run/real/RobotName";
import { chooseRobot, chosenRobot, realRobots, SIMULATOR } from "../../run/real/real_robot";
import { robotStates } from "../../run/real/robot_state";
import { stateWords } from "../../run/real/state_words";
import { isLive } from "../../run/reducer";

/** The simulator or a real robot; shown where the teacher has set up one. */
export function RobotChoice() {
  const { robot: say } = texts.value;
  const ready = realRobots.value.filter((one) => one.is_set_up);
  if (ready.length === 0) return null;
  const chosen = chosenRobot.value?.link;
  return (
    <Select
      icon={Bot}
      label={say.choice}
      tip={chosen ? `${say.choice}: ${stateWords(robotStates.value[chosen]).short}` : say.choice}
      testId="robot-choice"
      value={chosen ?? SIMULATOR}
      options={[
        [SIMULATOR, say.simulator],
        ...ready.map(({ link }) => [link, robotWords(link)] as const),
      ]}
      disabled={isLive(robot.live.value)}
      onChange={(link) => {
        chooseRobot(link);
        robot.clear();
      }}
    />
  );
}
