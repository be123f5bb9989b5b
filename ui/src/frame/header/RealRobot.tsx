import { OctagonX } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { texts } from "../../i18n";
import { labelled } from "../../i18n/phrases";
import { Button } from "../../kit/Button";
import { listen } from "../../kit/listen";
import { robotLabel } from "../../run/real/RobotName";
import { RobotState } from "../../run/real/RobotState";
import { activeRealLink, EMERGENCY_KEY, emergencyStop } from "../../run/real/real_robot";
import { useWatchedRobot } from "../../run/real/robot_state";
import { report } from "../../shell/session";

const halt = () => void emergencyStop().catch(report);

/** While a real robot may move, shows its name and the emergency stop. */
export function RealRobot() {
  const { value: link } = activeRealLink;
  useEffect(
    () => (link ? listen(window, { keydown: onKey }, { capture: true }) : undefined),
    [link],
  );
  useWatchedRobot(link);
  if (!link) return null;
  const { robot } = texts.value;
  return (
    <section
      class="real-robot row middle rigid shrinks gap-2"
      aria-label={labelled(robot.real, robotLabel(link))}
      data-testid="real-robot"
    >
      <span class="real-robot__words column">
        <strong>{robot.real}</strong>
        <RobotState link={link} testId="robot-state" />
      </span>
      <Button
        class="real-robot__stop"
        kind="stop"
        icon={OctagonX}
        tip={`${robot.emergencyHelp} (${EMERGENCY_KEY})`}
        testId="emergency-stop"
        aria-keyshortcuts={EMERGENCY_KEY}
        onPress={halt}
      >
        {robot.emergency}
        <span class="real-robot__what">{robot.emergencyWhat}</span>
        <kbd class="real-robot__key">{EMERGENCY_KEY}</kbd>
      </Button>
    </section>
  );
}

/**
 * Stops the robot at the emergency key, also with modifiers and on key repeat: any press of the key
 * means an emergency.
 */
function onKey(event: KeyboardEvent): void {
  if (event.key !== EMERGENCY_KEY) return;
  event.preventDefault();
  event.stopPropagation();
  halt();
}
