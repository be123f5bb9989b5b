import { Bot } from "lucide-preact";
import { texts } from "../../i18n";
import { SIMULATOR } from "./real_robot";

interface RobotNameProps {
  link: string;
}

/** Names the real robot of a run; nothing for the simulator. */
export function RobotName({ link }: RobotNameProps) {
  if (link === SIMULATOR) return null;
  return (
    <span class="robot-name" data-testid="robot-name" data-link={link}>
      <Bot class="icon" aria-hidden="true" />
      {robotWords(link)}
    </span>
  );
}

const LINKS = ["dds", "ros2", "bridge"] as const;

/** The link, where this release knows it. */
export const knownLink = (link: string) => LINKS.find((one) => one === link);

/** The name of a real robot's kind; that of a newer release is its link. */
export function robotWords(link: string): string {
  const known = knownLink(link);
  return known ? texts.value.robot.names[known] : link;
}
