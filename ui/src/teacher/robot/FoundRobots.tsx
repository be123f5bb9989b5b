import { Search } from "lucide-preact";
import { useEffect, useState } from "preact/hooks";
import type { FoundRobots as Found, FoundRobot, RealRobot } from "../../api/model";
import { robotsApi } from "../../api/robots";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { useAction } from "../../kit/requests/action";
import { FaultLine } from "../../kit/requests/FaultLine";
import { asTeacher } from "../../shell/teacher/teacher_session";
import { type Draft, descriptionOf } from "./robot_description";

interface FoundRobotsProps {
  robot: RealRobot;
  draft: Draft;
  fill(texts: Draft): void;
}

/** The robots in the DDS domain of the form; a press copies a robot's data into the form. */
export function FoundRobots({ robot, draft, fill }: FoundRobotsProps) {
  const { find: labels } = texts.value.robotSetup;
  const [found, setFound] = useState<Found | null>(null);
  const [isUsed, setUsed] = useState(false);
  useEffect(() => setUsed(false), [robot]); // the form was saved
  const { busy, fault, act } = useAction(asTeacher);
  const search = () => {
    setFound(null);
    setUsed(false);
    return act(async () =>
      setFound(await robotsApi.find(robot.link, descriptionOf(robot.fields, draft))),
    );
  };
  const use = ({ namespace, command_topic, odometry_topic }: FoundRobot) => {
    fill({ namespace, command_topic, odometry_topic });
    setUsed(true);
  };
  return (
    <div class="robots-found">
      <Button icon={Search} busy={busy} testId="robots-find" onPress={search}>
        {labels.ask}
      </Button>
      <p class="labelled__hint">{labels.hint({ domain: draft.domain ?? "" })}</p>
      <p role="status" class="teacher__done">
        {busy && labels.asking}
        {found?.robots.length === 0 && labels.none({ domain: found.domain })}
        {isUsed && labels.used}
      </p>
      {found && found.robots.length > 0 && <List robots={found.robots} onUse={use} />}
      <FaultLine fault={fault} />
    </div>
  );
}

interface ListProps {
  robots: readonly FoundRobot[];
  onUse(robot: FoundRobot): void;
}

function List({ robots, onUse }: ListProps) {
  const { find: labels } = texts.value.robotSetup;
  const { state } = texts.value.robot;
  return (
    <ul class="robots-found__list grid gap-2">
      {robots.map((one) => (
        <li
          key={`${one.namespace} ${one.command_topic}`}
          data-testid="robot-on-network"
          data-namespace={one.namespace}
        >
          <span>
            <strong>{one.namespace || labels.nameless}</strong>{" "}
            {labels.topics({ command: one.command_topic, odometry: one.odometry_topic })}
            {" · "}
            {one.holder ? state.held({ name: one.holder }) : labels.free}
          </span>
          <Button testId="robot-use" onPress={() => onUse(one)}>
            {labels.use}
          </Button>
        </li>
      ))}
    </ul>
  );
}
