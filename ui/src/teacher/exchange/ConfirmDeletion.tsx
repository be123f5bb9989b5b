import type { ComponentChildren } from "preact";
import { Button } from "../../kit/Button";

interface ConfirmDeletionProps {
  /** Labels of the two buttons. */
  confirm: string;
  cancel: string;
  testId?: string;
  confirmId: string;
  onConfirm(): unknown;
  onCancel(): void;
  /** Description of the data that will be deleted. */
  children: ComponentChildren;
}

/** Asks for confirmation of a permanent deletion. */
export function ConfirmDeletion(props: ConfirmDeletionProps) {
  const { confirm, cancel, testId, confirmId, onConfirm, onCancel, children } = props;
  return (
    <div class="deletion__sure notice-box" data-testid={testId}>
      <p>{children}</p>
      <div class="button-row">
        <Button kind="stop" testId={confirmId} onPress={onConfirm}>
          {confirm}
        </Button>
        <Button onPress={onCancel}>{cancel}</Button>
      </div>
    </div>
  );
}
