import { Check, RefreshCcw } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { isRunning } from "../../run/live";
import { isSwapDue, restartSwapTimer, startSwapTimer } from "../../shell/swap_timer";

/** Reminder that the pupils swap the mouse; hidden during a run. */
export function SwapReminder({ group }: { group: string }) {
  const { classes } = texts.value;
  useEffect(() => startSwapTimer(group), [group]);
  if (!isSwapDue.value || isRunning.value) return null;
  return (
    <div class="line-message way-back" role="status" data-testid="turns">
      <RefreshCcw class="icon" aria-hidden="true" />
      <span>
        <strong>{classes.turnsTitle}</strong> {classes.turns}
      </span>
      <Button icon={Check} testId="turns-done" onPress={restartSwapTimer}>
        {classes.turnsDone}
      </Button>
    </div>
  );
}
