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
export function KeyHelp({ actions }: { actions: readonly Action[] }) {
  const { projector } = texts.value;
  return (
    <ul class="presentation__keys" aria-label={projector.keys} data-testid="presentation-keys">
      {actions.map((action) => (
        <li key={action}>
          <kbd>{KEYS[action]}</kbd> {projector.does[action]}
        </li>
      ))}
    </ul>
  );
}
