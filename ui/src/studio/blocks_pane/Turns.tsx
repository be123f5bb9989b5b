import { Check, RefreshCcw } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { isRunning } from "../app/session";
import { TEST } from "../app/testids";
import { countTurns, isTurn, nextTurn } from "../app/turns";
import { texts } from "../i18n";

/** Time to swap, said in a line; never while the robot drives. */
export function Turns({ group }: { group: string }) {
  const { classes } = texts.value;
  useEffect(() => countTurns(group), [group]);
  if (!isTurn.value || isRunning.value) return null;
  return (
    <div class="line-message turns" role="status" data-testid={TEST.turns}>
      <RefreshCcw class="icon" aria-hidden="true" />
      <span>
        <strong>{classes.turnsTitle}</strong> {classes.turns}
      </span>
      <button type="button" class="button" data-testid={TEST.turnsDone} onClick={nextTurn}>
        <Check class="icon" aria-hidden="true" />
        {classes.turnsDone}
      </button>
    </div>
  );
}
