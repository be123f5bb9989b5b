import { Pencil } from "lucide-preact";
import { useRef, useState } from "preact/hooks";
import { STORE_LIMITS } from "../../api/declared";
import { texts } from "../../i18n";
import { route } from "../../shell/route";
import { program } from "../../shell/session";
import { renameProgram } from "../../studio/program/rename";

/** The program's name, edited in place: Enter or blur saves it, Escape restores it. */
export function ProgramName() {
  const { header } = texts.value;
  const now = program.value;
  const [draft, setDraft] = useState<string | null>(null);
  const input = useRef<HTMLInputElement>(null);
  if (!now || route.value.screen === "work") return null;

  const finish = () => {
    setDraft(null);
    if (draft !== null) void renameProgram(draft);
  };

  return (
    <label class="program-name grid middle" title={header.rename}>
      <span class="program-name__sizer" aria-hidden="true">
        {draft ?? now.name}
      </span>
      <input
        ref={input}
        class="program-name__input"
        data-testid="program-name"
        aria-label={header.programName}
        maxLength={STORE_LIMITS.MAX_NAME}
        spellcheck={false}
        value={draft ?? now.name}
        onFocus={(event) => event.currentTarget.select()}
        onInput={(event) => setDraft(event.currentTarget.value)}
        onBlur={finish}
        onKeyDown={(event) => {
          if (event.key === "Escape") setDraft(null);
          if (event.key === "Enter") input.current?.blur();
        }}
      />
      <Pencil class="icon program-name__pen" aria-hidden="true" />
    </label>
  );
}
