import { texts } from "../../i18n";
import { Button, type ButtonProps } from "../../kit/Button";
import type { StudioControl } from "../studio_control";
import type { RunAction, RunState } from "./actions";

export interface ActionsProps {
  control: StudioControl;
  state: RunState;
}

interface ActionButtonProps extends ActionsProps, Pick<ButtonProps, "kind" | "filled" | "class"> {
  action: RunAction;
}

/** The button of one action. */
export function ActionButton({ action, control, state, ...appearance }: ActionButtonProps) {
  const labels = texts.value;
  return (
    <Button
      {...appearance}
      icon={action.icon(state)}
      tip={`${action.help?.(labels) ?? action.label(labels, state)} (${action.shortcut})`}
      testId={action.testId}
      data-does={action.name}
      aria-keyshortcuts={action.shortcut}
      disabled={!action.isReady(state)}
      onPress={() => action.perform(control, state)}
    >
      {action.label(labels, state)}
    </Button>
  );
}
