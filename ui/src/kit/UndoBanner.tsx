import { type LucideIcon, Undo2, X } from "lucide-preact";
import { texts } from "../i18n";
import { Button } from "./Button";

interface UndoBannerProps {
  /** What has happened, and the name of its undo action. */
  text: string;
  action: string;
  Icon?: LucideIcon;
  testId: string;
  onBack(): unknown;
  onClose(): void;
}

/** A line that offers undo after something was replaced, deleted or superseded. */
export function UndoBanner({
  text,
  action,
  Icon = Undo2,
  testId,
  onBack,
  onClose,
}: UndoBannerProps) {
  const { close } = texts.value.trouble;
  return (
    <div class="line-message way-back" role="status">
      <span>{text}</span>
      <Button icon={Icon} testId={testId} onPress={onBack}>
        {action}
      </Button>
      <Button kind="plain" class="way-back__close" icon={X} label={close} onPress={onClose} />
    </div>
  );
}
