import { CircleAlert, CircleCheck } from "lucide-preact";
import { useEffect } from "preact/hooks";
import type { JudgedEvent } from "../../api/model";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import type { Ghost } from "../ghost";

interface CasesTriedProps extends Pick<JudgedEvent, "cases"> {
  ghost: Ghost;
}

/** The further signs, answers or starts with which the judge ran the program; a press shows the robot in one of them. */
export function CasesTried({ cases, ghost }: CasesTriedProps) {
  const { activity } = texts.value;
  useEffect(() => () => ghost.hide(), [cases, ghost]);
  const others = cases.filter(({ seen }) => !seen);
  if (others.length === 0) return null;
  return (
    <div class="mission__cases" data-testid="cases-tried">
      <span>{activity.alsoTried}</span>
      <ul>
        {others.map((one) => (
          <li key={one.given} class="checks__line" data-state={one.passed ? "met" : "broken"}>
            <Button
              class="checks__case"
              icon={one.passed ? CircleCheck : CircleAlert}
              tip={activity.showCase}
              testId="case"
              pressed={ghost.shown.value === one}
              onPress={() => ghost.toggle(one)}
            >
              {one.given}
              <span class="visually-hidden">
                : {activity.checkStates[one.passed ? "met" : "broken"]}
              </span>
            </Button>
          </li>
        ))}
      </ul>
    </div>
  );
}
