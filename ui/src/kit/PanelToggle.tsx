import type { LucideIcon } from "lucide-preact";
import { Button } from "./Button";

interface PanelToggleProps {
  testId: string;
  icon: LucideIcon;
  /** Visible text; `label` is the full name. */
  text: string;
  label: string;
  open: boolean;
  disabled?: boolean;
  onPress(): void;
}

/** Opens and closes a panel below the floor. */
export function PanelToggle({ text, label, ...rest }: PanelToggleProps) {
  return (
    <Button {...rest} kind="plain" class="floor__opener" label={label} tip={label}>
      <span>{text}</span>
    </Button>
  );
}
