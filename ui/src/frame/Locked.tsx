import { Lock } from "lucide-preact";
import { texts } from "../i18n";

/** Shown if the session cookie is missing: only the app can open the page. */
export function Locked() {
  const { trouble } = texts.value;
  return (
    <main class="locked column middle center gap-3" data-testid="locked">
      <Lock class="locked__icon" aria-hidden="true" />
      <h1>{trouble.lockedTitle}</h1>
      <p>{trouble.locked}</p>
      <p>
        <strong>{trouble.lockedRemedy}</strong>
      </p>
    </main>
  );
}
