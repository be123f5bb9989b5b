import { Circle, CircleAlert, CircleCheck, type LucideIcon } from "lucide-preact";
import type { CheckProgress } from "../../api/model";
import { texts } from "../../i18n";

const ICONS: Readonly<Record<CheckProgress["state"], LucideIcon>> = {
  open: Circle,
  met: CircleCheck,
  broken: CircleAlert,
};

/** The checks, one a line: met so far, not yet met, or impossible to meet in this run. */
export function CheckList({ checks }: { checks: readonly CheckProgress[] }) {
  const { activity } = texts.value;
  return (
    <ul class="checks" aria-label={activity.criteria} data-testid="checks">
      {checks.map(({ criterion, measured, state }, index) => {
        const Icon = ICONS[state];
        return (
          <li key={index} class="checks__line" data-state={state}>
            <Icon class="icon checks__mark" aria-hidden="true" />
            <span>
              {criterion}
              <span class="visually-hidden">: {activity.checkStates[state]}</span>
              {measured && <span class="checks__measured"> · {measured}</span>}
            </span>
          </li>
        );
      })}
    </ul>
  );
}
