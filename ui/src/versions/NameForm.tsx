import { Check } from "lucide-preact";
import { useEffect, useRef } from "preact/hooks";
import { STORE_LIMITS } from "../api/declared";
import { texts } from "../i18n";
import { Button } from "../kit/Button";

interface NameFormProps {
  now: string;
  onKeep(text: string): void;
  onLeave(): void;
}

/** Form that names a version. */
export function NameForm({ now, onKeep, onLeave }: NameFormProps) {
  const field = useRef<HTMLInputElement>(null);
  const words = texts.value.keeping;
  useEffect(() => field.current?.select(), []);
  return (
    <form
      class="versions__naming"
      onSubmit={(event) => {
        event.preventDefault();
        onKeep(field.current?.value ?? "");
      }}
      onKeyDown={({ key }) => key === "Escape" && onLeave()}
    >
      <input
        ref={field}
        class="field"
        aria-label={words.nameLabel}
        placeholder={words.namePlaceholder}
        maxLength={STORE_LIMITS.MAX_NAME}
        defaultValue={now}
        data-testid="version-name"
      />
      <Button icon={Check} kind="main" submit testId="version-keep-name">
        {words.keepName}
      </Button>
      <Button kind="plain" onPress={onLeave}>
        {words.leaveName}
      </Button>
    </form>
  );
}
