import { Check } from "lucide-preact";
import { useEffect, useRef } from "preact/hooks";
import { LONGEST_NAME } from "../app/rename";
import { TEST } from "../app/testids";
import { texts } from "../i18n";

interface NameFormProps {
  now: string;
  onKeep(text: string): void;
  onLeave(): void;
}

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
        maxLength={LONGEST_NAME}
        defaultValue={now}
        data-testid={TEST.versionName}
      />
      <button type="submit" class="button button--run" data-testid={TEST.versionKeepName}>
        <Check class="icon" aria-hidden="true" />
        {words.keepName}
      </button>
      <button type="button" class="button button--plain" onClick={onLeave}>
        {words.leaveName}
      </button>
    </form>
  );
}
