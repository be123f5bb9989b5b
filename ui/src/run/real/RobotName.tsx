import { Bot } from "lucide-preact";
import { language } from "../../i18n";
import { linkText } from "../../i18n/reasons";
import { SIMULATOR } from "./real_robot";

interface RobotNameProps {
  link: string;
}

/** Shows the name of a run's real robot; renders nothing for the simulator. */
export function RobotName({ link }: RobotNameProps) {
  if (link === SIMULATOR) return null;
  return (
    <span class="robot-name" data-testid="robot-name" data-link={link}>
      <Bot class="icon" aria-hidden="true" />
      {robotLabel(link)}
    </span>
  );
}

/** The name of a kind of real robot; for a kind of a newer release, the name of its link. */
export const robotLabel = (link: string): string => linkText(link, language.value)?.message ?? link;
