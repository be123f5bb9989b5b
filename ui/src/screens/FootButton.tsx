import type { FileCode } from "lucide-preact";

interface FootButtonProps {
  testId: string;
  Icon: typeof FileCode;
  /** In one word, and in full. */
  word: string;
  label: string;
  open: boolean;
  disabled?: boolean;
  onClick(): void;
}

/** Opens and closes what lies under the floor. */
export function FootButton({
  testId,
  Icon,
  word,
  label,
  open,
  disabled = false,
  onClick,
}: FootButtonProps) {
  return (
    <button
      type="button"
      class="button button--plain floor__opener"
      data-testid={testId}
      aria-expanded={open}
      aria-label={label}
      title={label}
      disabled={disabled}
      onClick={onClick}
    >
      <Icon class="icon" aria-hidden="true" />
      <span>{word}</span>
    </button>
  );
}
