import { Bot } from "lucide-preact";
import { language } from "../../i18n";
import { linkText } from "../../i18n/reasons";
import { SIMULATOR } from "./real_robot";

interface RobotNameProps {
  link: string;
  /** Name of the calibrated robot of a simulated run. */
  calibrated: string | null;
}

/** Shows the name of a run's real or calibrated robot; renders nothing for the others of the simulator. */
export function RobotName({ link, calibrated }: RobotNameProps) {
  if (link === SIMULATOR && !calibrated) return null;
  return (
    <span class="robot-name" data-testid="robot-name" data-link={link}>
      <Bot class="icon" aria-hidden="true" />
      {calibrated ?? robotLabel(link)}
    </span>
  );
}

/** The name of a kind of real robot; for a kind of a newer release, the name of its link. */
export const robotLabel = (link: string): string => linkText(link, language.value)?.message ?? link;
