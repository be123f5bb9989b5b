import { type LucideIcon, Undo2, X } from "lucide-preact";
import type { TEST } from "../app/testids";
import { texts } from "../i18n";

interface WayBackProps {
  /** What has happened, and what would undo it. */
  words: string;
  action: string;
  Icon?: LucideIcon;
  testId: (typeof TEST)[keyof typeof TEST];
  onBack(): void;
  onClose(): void;
}

/** After something whole was replaced, deleted or overtaken: a line with the way to it. */
export function WayBack({ words, action, Icon = Undo2, testId, onBack, onClose }: WayBackProps) {
  const { close } = texts.value.trouble;
  return (
    <div class="line-message way-back" role="status">
      <span>{words}</span>
      <button type="button" class="button" data-testid={testId} onClick={onBack}>
        <Icon class="icon" aria-hidden="true" />
        {action}
      </button>
      <button
        type="button"
        class="button button--plain button--icon way-back__close"
        aria-label={close}
        title={close}
        onClick={onClose}
      >
        <X class="icon" aria-hidden="true" />
      </button>
    </div>
  );
}
