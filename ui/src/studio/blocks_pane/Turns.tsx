import { Check, RefreshCcw } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { isRunning } from "../../run/live";
import { TEST } from "../../shell/testids";
import { countTurns, isTurn, nextTurn } from "../../shell/turns";

/** Time to swap, said in a line; never while the robot drives. */
export function Turns({ group }: { group: string }) {
  const { classes } = texts.value;
  useEffect(() => countTurns(group), [group]);
  if (!isTurn.value || isRunning.value) return null;
  return (
    <div class="line-message way-back" role="status" data-testid={TEST.turns}>
      <RefreshCcw class="icon" aria-hidden="true" />
      <span>
        <strong>{classes.turnsTitle}</strong> {classes.turns}
      </span>
      <Button icon={Check} testId={TEST.turnsDone} onPress={nextTurn}>
        {classes.turnsDone}
      </Button>
    </div>
  );
}
