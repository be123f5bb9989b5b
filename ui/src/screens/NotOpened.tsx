import { House } from "lucide-preact";
import { texts } from "../i18n";

/** Stands where something could not be opened; the line above says why. */
export function NotOpened() {
  return (
    <main class="screen not-opened">
      <a class="button" href="#/">
        <House class="icon" aria-hidden="true" />
        {texts.value.trouble.back}
      </a>
    </main>
  );
}
