import type { LucideIcon } from "lucide-preact";
import { Button } from "./Button";

interface FootButtonProps {
  testId: string;
  icon: LucideIcon;
  /** In one word, and in full. */
  word: string;
  label: string;
  open: boolean;
  disabled?: boolean;
  onPress(): void;
}

/** Opens and closes what lies under the floor. */
export function FootButton({ word, label, ...rest }: FootButtonProps) {
  return (
    <Button {...rest} kind="plain" class="floor__opener" label={label} tip={label}>
      <span>{word}</span>
    </Button>
  );
}
