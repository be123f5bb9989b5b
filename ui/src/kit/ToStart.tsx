import { House } from "lucide-preact";
import { texts } from "../i18n";
import { LinkButton } from "./LinkButton";

/** Link to the start screen. */
export function ToStart() {
  return (
    <LinkButton icon={House} href="#/">
      {texts.value.trouble.back}
    </LinkButton>
  );
}
