import { Check } from "lucide-preact";
import { useEffect, useRef } from "preact/hooks";
import { STORE_LIMITS } from "../api/declared";
import { texts } from "../i18n";
import { Button } from "../kit/Button";

interface NameFormProps {
  now: string;
  onSave(text: string): void;
  onLeave(): void;
}

/** Form that names a version. */
export function NameForm({ now, onSave, onLeave }: NameFormProps) {
  const field = useRef<HTMLInputElement>(null);
  const labels = texts.value.archive;
  useEffect(() => field.current?.select(), []);
  return (
    <form
      class="versions__naming"
      onSubmit={(event) => {
        event.preventDefault();
        onSave(field.current?.value ?? "");
      }}
      onKeyDown={({ key }) => key === "Escape" && onLeave()}
    >
      <input
        ref={field}
        class="field"
        aria-label={labels.nameLabel}
        placeholder={labels.namePlaceholder}
        maxLength={STORE_LIMITS.MAX_NAME}
        defaultValue={now}
        data-testid="version-name"
      />
      <Button icon={Check} kind="main" submit testId="version-keep-name">
        {labels.keepName}
      </Button>
      <Button kind="plain" onPress={onLeave}>
        {labels.leaveName}
      </Button>
    </form>
  );
}
