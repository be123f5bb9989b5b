import type { LucideIcon } from "lucide-preact";
import { Button } from "./Button";

interface FootButtonProps {
  testId: string;
  icon: LucideIcon;
  /** Visible text; `label` is the full name. */
  word: string;
  label: string;
  open: boolean;
  disabled?: boolean;
  onPress(): void;
}

/** Opens and closes a panel below the floor. */
export function FootButton({ word, label, ...rest }: FootButtonProps) {
  return (
    <Button {...rest} kind="plain" class="floor__opener" label={label} tip={label}>
      <span>{word}</span>
    </Button>
  );
}
