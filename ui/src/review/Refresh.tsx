import { RefreshCw } from "lucide-preact";
import { TEST } from "../app/testids";
import { language } from "../i18n";
import { words } from "../i18n/review";
import { clock } from "./mark_words";

interface RefreshProps {
  /** When what is shown was so. */
  at: Date;
  busy: boolean;
  onRefresh(): void;
}

/** Asks again for what goes on meanwhile, and says as of when it is shown. */
export function Refresh({ at, busy, onRefresh }: RefreshProps) {
  const texts = words.value.refresh;
  return (
    <button
      type="button"
      class="button refresh"
      title={texts.help}
      aria-busy={busy}
      data-testid={TEST.reviewRefresh}
      data-at={at.toISOString()}
      onClick={() => {
        if (!busy) onRefresh();
      }}
    >
      <RefreshCw class="icon" aria-hidden="true" />
      {texts.again}{" "}
      <span class="refresh__at">{texts.at(clock(at.toISOString(), language.value))}</span>
    </button>
  );
}
