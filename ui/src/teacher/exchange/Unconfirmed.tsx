import type { KnownComputerList } from "../../api/model";
import { texts } from "../../i18n";

interface UnconfirmedProps {
  counts: KnownComputerList["unconfirmed"];
}

/** Numbers of merged runs that await re-verification, that differed from their file, or cannot be repeated. */
export function Unconfirmed({ counts }: UnconfirmedProps) {
  const { unconfirmed: labels } = texts.value.exchange;
  const wrong = counts.differs + counts.not_passed;
  if (counts.waiting + wrong + counts.not_repeatable === 0) return null;
  return (
    <div class="notice-box" role="status" data-testid="unconfirmed">
      {counts.waiting > 0 && <p>{labels.waiting({ count: counts.waiting })}</p>}
      {wrong > 0 && (
        <p>
          <strong>{labels.wrong({ count: wrong })}</strong> {labels.wrongWhere}
        </p>
      )}
      {counts.not_repeatable > 0 && <p>{labels.notRepeatable({ count: counts.not_repeatable })}</p>}
    </div>
  );
}
