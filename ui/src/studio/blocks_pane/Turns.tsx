import { Check, RefreshCcw } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { isRunning } from "../../run/live";
import { isTurnOver, restartTurn, startTurns } from "../../shell/turns";

/** Reminder to swap who has the mouse; hidden during a run. */
export function Turns({ group }: { group: string }) {
  const { classes } = texts.value;
  useEffect(() => startTurns(group), [group]);
  if (!isTurnOver.value || isRunning.value) return null;
  return (
    <div class="line-message way-back" role="status" data-testid="turns">
      <RefreshCcw class="icon" aria-hidden="true" />
      <span>
        <strong>{classes.turnsTitle}</strong> {classes.turns}
      </span>
      <Button icon={Check} testId="turns-done" onPress={restartTurn}>
        {classes.turnsDone}
      </Button>
    </div>
  );
}
