import { Search } from "lucide-preact";
import { useEffect, useState } from "preact/hooks";
import type { FoundRobots as Found, FoundRobot, RealRobot } from "../../api/model";
import { robotsApi } from "../../api/robots";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { useAct } from "../../kit/requests/act";
import { FaultLine } from "../../kit/requests/FaultLine";
import { asTeacher } from "../../shell/teacher/teacher_session";
import { type Draft, recordOf } from "./record";

interface FoundRobotsProps {
  robot: RealRobot;
  draft: Draft;
  fill(texts: Draft): void;
}

/** The robots in the domain that is typed; one of them can be taken over into the form. */
export function FoundRobots({ robot, draft, fill }: FoundRobotsProps) {
  const { find: say } = texts.value.robotSetup;
  const [found, setFound] = useState<Found | null>(null);
  const [isUsed, setUsed] = useState(false);
  useEffect(() => setUsed(false), [robot]); // it was saved
  const { busy, fault, act } = useAct(asTeacher);
  const look = () => {
    setFound(null);
    setUsed(false);
    return act(async () =>
      setFound(await robotsApi.find(robot.link, recordOf(robot.fields, draft))),
    );
  };
  const use = ({ namespace, command_topic, odometry_topic }: FoundRobot) => {
    fill({ namespace, command_topic, odometry_topic });
    setUsed(true);
  };
  return (
    <div class="robots-found">
      <Button icon={Search} busy={busy} testId="robots-find" onPress={look}>
        {say.ask}
      </Button>
      <p class="labelled__hint">{say.hint(draft.domain ?? "")}</p>
      <p role="status" class="teacher__done">
        {busy && say.asking}
        {found?.robots.length === 0 && say.none(found.domain)}
        {isUsed && say.used}
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
  const { find: say } = texts.value.robotSetup;
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
            <strong>{one.namespace || say.nameless}</strong>{" "}
            {say.topics(one.command_topic, one.odometry_topic)}
            {" · "}
            {one.holder ? state.held(one.holder) : say.free}
          </span>
          <Button testId="robot-use" onPress={() => onUse(one)}>
            {say.use}
          </Button>
        </li>
      ))}
    </ul>
  );
}
