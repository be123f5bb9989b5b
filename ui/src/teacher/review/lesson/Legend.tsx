import { texts } from "../../../i18n";
import { OutcomeIcon } from "../OutcomeIcon";

const OUTCOMES = ["passed", "finished", "notyet", "stopped", "failed"] as const;

/** Legend of the events on the timelines. */
export function Legend() {
  const { legend } = texts.value.review;
  return (
    <ul class="legend aside" aria-label={legend.title}>
      <li>
        <span class="legend__bar" aria-hidden="true" />
        {legend.edit}
      </li>
      {OUTCOMES.map((outcome) => (
        <li key={outcome}>
          <OutcomeIcon outcome={outcome} />
          {legend[outcome]}
        </li>
      ))}
      <li>
        <svg class="legend__arc" viewBox="0 0 30 16" aria-hidden="true">
          <path class="line__arc" d="M3 14C3 1 25 1 25 14M21 9l4 5 3-6" />
        </svg>
        {legend.repair}
      </li>
    </ul>
  );
}
