import type { KnownComputerList } from "../../api/model";
import { texts } from "../../i18n";

interface UnconfirmedProps {
  counts: KnownComputerList["unconfirmed"];
}

/** How many runs of files wait to be checked, and how many did not come out as their file says. */
export function Unconfirmed({ counts }: UnconfirmedProps) {
  const { unconfirmed: labels } = texts.value.exchange;
  const wrong = counts.differs + counts.not_passed;
  if (counts.waiting + wrong + counts.not_repeatable === 0) return null;
  return (
    <div class="notice-box" role="status" data-testid="unconfirmed">
      {counts.waiting > 0 && <p>{labels.waiting(counts.waiting)}</p>}
      {wrong > 0 && (
        <p>
          <strong>{labels.wrong(wrong)}</strong> {labels.wrongWhere}
        </p>
      )}
      {counts.not_repeatable > 0 && <p>{labels.notRepeatable(counts.not_repeatable)}</p>}
    </div>
  );
}
