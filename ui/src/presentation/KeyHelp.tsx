import { texts } from "../i18n";
import type { Action } from "./keys";

const KEYS = {
  next: "→",
  previous: "←",
  play: "P",
  names: "N",
  solid: "3",
  black: "B",
  help: "?",
  leave: "Esc",
} as const satisfies Record<Action, string>;

/** The keys, until one of them is pressed. */
export function KeyHelp() {
  const { projector } = texts.value;
  const lines = Object.entries(KEYS) as [Action, string][];
  return (
    <ul class="presentation__keys" aria-label={projector.keys} data-testid="presentation-keys">
      {lines.map(([action, key]) => (
        <li key={action}>
          <kbd>{key}</kbd> {projector.does[action]}
        </li>
      ))}
    </ul>
  );
}
