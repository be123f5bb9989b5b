import { CircleCheck, Info, Navigation, TriangleAlert } from "lucide-preact";
import { useEffect, useState } from "preact/hooks";
import { texts } from "../../i18n";
import type { Sentence, Tone } from "../sentence";

const ICONS: Record<Tone, typeof Info> = {
  calm: Info,
  moving: Navigation,
  done: CircleCheck,
  notice: Info,
  fault: TriangleAlert,
};

/** Delay before a screen reader announces a sentence, so that it does not announce every centimetre. */
const SETTLE_MS = 400;

/** The robot's current action in one line of text. */
export function StatusLine({ sentence }: { sentence: Sentence }) {
  const Icon = ICONS[sentence.tone];
  return (
    <div
      class={`status row middle gap-3 status--${sentence.tone}`}
      data-testid="status-line"
      data-tone={sentence.tone}
    >
      <Icon class="icon status__icon" aria-hidden="true" />
      <p class="status__words column shrinks" title={`${sentence.text} ${sentence.detail}`.trim()}>
        <span class="status__text">{sentence.text}</span>
        {sentence.detail && !sentence.isAtBlock && (
          <span class="status__more">{sentence.detail}</span>
        )}
      </p>
      {sentence.part != null && (
        <span
          class="status__part"
          aria-hidden="true"
          style={{ transform: `scaleX(${sentence.part})` }}
        />
      )}
      <Spoken text={spoken(sentence)} />
    </div>
  );
}

/** Both parts as sentences. */
const spoken = ({ text, detail: more }: Sentence) =>
  [/[.!?…]$/.test(text) ? text : `${text}.`, more].join(" ").trim();

function Spoken({ text }: { text: string }) {
  const [announced, setAnnounced] = useState("");
  const kind = text.replace(/[\d,.\u2212]+/g, "");
  useEffect(() => {
    const timer = setTimeout(() => setAnnounced(text), SETTLE_MS);
    return () => clearTimeout(timer);
  }, [kind]);
  return (
    <p
      class="visually-hidden"
      role="status"
      aria-live="polite"
      aria-label={texts.value.status.label}
    >
      {announced}
    </p>
  );
}
