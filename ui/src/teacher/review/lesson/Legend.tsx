import { words } from "../i18n/review";
import { Sign } from "./Sign";

const OUTCOMES = ["passed", "finished", "notyet", "stopped", "failed"] as const;

/** What the marks say. */
export function Legend() {
  const { legend } = words.value;
  return (
    <ul class="legend" aria-label={legend.title}>
      <li>
        <span class="legend__bar" aria-hidden="true" />
        {legend.edit}
      </li>
      {OUTCOMES.map((outcome) => (
        <li key={outcome}>
          <Sign outcome={outcome} />
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
