import type { Activity, JudgedEvent } from "../../api/model";
import { texts } from "../../i18n";
import { activeRealLink } from "../../run/real/real_robot";
import { JudgingLine, VerdictLine } from "../../run/real/VerdictLine";

interface HowJudgedProps {
  mission: Pick<Activity, "not_on_robot">;
  verdict: JudgedEvent | null;
}

/** For a real robot: how its run was judged or why not; before a run, whether it will be judged. */
export function HowJudged({ mission, verdict }: HowJudgedProps) {
  if (verdict?.by_robot || verdict?.not_judged) return <VerdictLine of={verdict} />;
  if (!activeRealLink.value) return null;
  const { not_on_robot } = mission;
  if (not_on_robot) return <JudgingLine state="not_judged">{not_on_robot}</JudgingLine>;
  return <JudgingLine state="will_be">{texts.value.robot.willBeJudged}</JudgingLine>;
}
