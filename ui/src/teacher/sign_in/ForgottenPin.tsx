import { texts } from "../../i18n";
import { hashOf } from "../../shell/route";

/** Who chooses another PIN, and the manual that says how. */
export function ForgottenPin({ text }: { text: string }) {
  return (
    <p class="labelled__hint">
      {text}{" "}
      <a
        href={hashOf({ screen: "manuals", manual: "teacher", section: null })}
        data-testid="pin-forgotten"
      >
        {texts.value.teacher.door.forgottenHow}
      </a>
    </p>
  );
}
