import { texts } from "../../i18n";
import { level } from "../../shell/level";
import { CloudButton } from "../cloud/CloudButton";
import { ActionButton, type ActionsProps } from "./ActionButton";
import { RUN_PAUSE_RESUME, STOP } from "./actions";

/** The button for Run, Pause and Resume, and Stop, which is always shown. */
export function RunBar(props: ActionsProps) {
  const action = RUN_PAUSE_RESUME.find(({ isShown }) => isShown(props.state));
  return (
    <section class="run-bar" aria-label={texts.value.run.bar}>
      {action && (
        <ActionButton {...props} action={action} kind="main" filled class="run-bar__run" />
      )}
      <ActionButton {...props} action={STOP} kind="stop" filled class="run-bar__stop" />
      {level.value > 1 && <CloudButton {...props} />}
    </section>
  );
}
