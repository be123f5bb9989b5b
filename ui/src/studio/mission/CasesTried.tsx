import { CircleAlert, CircleCheck } from "lucide-preact";
import type { JudgedEvent } from "../../api/model";
import { texts } from "../../i18n";

/** The further signs, answers or starts with which the judge ran the program for the verdict. */
export function CasesTried({ cases }: Pick<JudgedEvent, "cases">) {
  const { activity } = texts.value;
  const others = cases.filter(({ seen }) => !seen);
  if (others.length === 0) return null;
  return (
    <div class="mission__cases" data-testid="cases-tried">
      <span>{activity.alsoTried}</span>
      <ul>
        {others.map(({ given, passed }) => {
          const Icon = passed ? CircleCheck : CircleAlert;
          return (
            <li key={given} class="checks__line" data-state={passed ? "met" : "broken"}>
              <Icon class="icon checks__mark" aria-hidden="true" />
              <span>
                {given}
                <span class="visually-hidden">
                  : {activity.checkStates[passed ? "met" : "broken"]}
                </span>
              </span>
            </li>
          );
        })}
      </ul>
    </div>
  );
}
