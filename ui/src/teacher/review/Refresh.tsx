import { RefreshCw } from "lucide-preact";
import { language, texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { timeOfDay } from "../time_format";

interface RefreshProps {
  /** The time of the last load. */
  at: Date;
  busy: boolean;
  onRefresh(): Promise<void>;
}

/** Loads again, and shows the time of the last load. */
export function Refresh({ at, busy, onRefresh }: RefreshProps) {
  const { refresh: labels } = texts.value.review;
  return (
    <Button
      class="refresh rigid"
      icon={RefreshCw}
      tip={labels.help}
      busy={busy}
      testId="review-refresh"
      data-at={at.toISOString()}
      onPress={onRefresh}
    >
      {labels.again}{" "}
      <span class="refresh__at">
        {labels.at({ time: timeOfDay(at.toISOString(), language.value) })}
      </span>
    </Button>
  );
}
