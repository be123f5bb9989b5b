import type { JudgedEvent } from "../../api/model";
import { texts } from "../../i18n";

interface VerdictLineProps {
  of: Pick<JudgedEvent, "by_robot" | "not_judged">;
}

/** How a run on a real robot was judged, or why it was not judged; nothing for a simulated run. */
export function VerdictLine({ of: { by_robot, not_judged } }: VerdictLineProps) {
  if (not_judged) return <JudgingLine state="not_judged">{not_judged}</JudgingLine>;
  if (!by_robot) return null;
  return <JudgingLine state="by_robot">{texts.value.robot.judgedByRobot}</JudgingLine>;
}

interface JudgingLineProps {
  state: "by_robot" | "not_judged" | "will_be";
  children: string;
}

/** A line about how runs on a real robot are judged. */
export function JudgingLine({ state, children }: JudgingLineProps) {
  return (
    <p class="verdict-line" data-state={state} data-testid="how-judged">
      {children}
    </p>
  );
}
