import type { OpenedHints } from "../../../api/model";
import { texts } from "../../../i18n";
import { hintsRead, labelled } from "../../../i18n/phrases";

interface HintsReadProps {
  hints: readonly OpenedHints[];
}

/** The hints that a group opened, with their texts. */
export function HintsRead({ hints }: HintsReadProps) {
  const { detail } = texts.value.review;
  if (hints.length === 0) return null;
  return (
    <div class="detail__hints" data-testid="review-hints">
      <h2 class="detail__title">{detail.hints}</h2>
      {hints.map(({ title, n, texts: read }) => (
        <section key={title}>
          <h3 class="detail__activity">{labelled(title, hintsRead(n, texts.value))}</h3>
          <ol>
            {read.map((hint) => (
              <li key={hint}>{hint}</li>
            ))}
          </ol>
        </section>
      ))}
    </div>
  );
}
