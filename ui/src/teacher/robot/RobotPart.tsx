import { useSignal } from "@preact/signals";
import type { RealRobot } from "../../api/model";
import { robotsApi } from "../../api/robots";
import { language, texts } from "../../i18n";
import { RadioGroup } from "../../kit/RadioGroup";
import { Loaded } from "../../kit/requests/Loaded";
import { robotLabel } from "../../run/real/RobotName";
import { realRobots } from "../../run/real/real_robot";
import { useTeacherLoaded } from "../useTeacherLoaded";
import { CalibrationPart } from "./calibration/CalibrationPart";
import { OverheadPart } from "./overhead/OverheadPart";
import { RobotForm } from "./RobotForm";

/** The real robots of this PC, with forms for address, limits and room. */
export function RobotPart() {
  const { robotSetup: labels } = texts.value;
  // the server sends the labels of the fields in the language of the page
  const robots = useTeacherLoaded(language.value, robotsApi.all);
  return (
    <>
      <h1>{labels.title}</h1>
      <p class="teacher__hint">{labels.hint}</p>
      <Loaded of={robots}>
        {(found) => (
          <Kinds
            robots={found}
            onChanged={(changed) => {
              const all = found.map((one) => (one.link === changed.link ? changed : one));
              robots.set(all);
              realRobots.value = all;
            }}
          />
        )}
      </Loaded>
      <OverheadPart />
      <CalibrationPart />
    </>
  );
}

interface KindsProps {
  robots: readonly RealRobot[];
  onChanged(robot: RealRobot): void;
}

function Kinds({ robots, onChanged }: KindsProps) {
  const { robotSetup: labels } = texts.value;
  const first = robots.find((one) => one.is_set_up) ?? robots[0];
  const link = useSignal(first?.link ?? "");
  const forgotten = useSignal(0); // counts deleted descriptions: after a deletion the form starts again
  const robot = robots.find((one) => one.link === link.value);
  if (!robot) return <p>{labels.none}</p>;
  return (
    <>
      <RadioGroup
        label={labels.kind}
        value={robot.link}
        options={robots.map((one) => [one.link, robotLabel(one.link)] as const)}
        onChange={(chosen) => {
          link.value = chosen;
        }}
        class="robot-kinds"
        testId="robot-kind"
      />
      <RobotForm
        key={`${robot.link} ${forgotten.value}`}
        robot={robot}
        onChanged={(changed) => {
          if (!changed.is_set_up) forgotten.value++;
          onChanged(changed);
        }}
      />
    </>
  );
}
