import { Pencil } from "lucide-preact";
import { useRef, useState } from "preact/hooks";
import { api } from "../api/client";
import { route } from "../app/route";
import { program, report } from "../app/session";
import { TEST } from "../app/testids";
import { texts } from "../i18n";

const LONGEST = 60;

/** The program's name, changed where it stands: type, then Enter or go elsewhere; Escape takes it back. */
export function ProgramName() {
  const { header } = texts.value;
  const now = program.value;
  const [draft, setDraft] = useState<string | null>(null);
  const input = useRef<HTMLInputElement>(null);
  if (!now || route.value.screen === "work") return null;

  const finish = async () => {
    const name = draft?.trim();
    setDraft(null);
    if (!name || name === now.name) return;
    program.value = { ...now, name };
    try {
      program.value = await api.renameProgram(now.id, name);
    } catch (error) {
      program.value = now;
      report(error);
    }
  };

  return (
    <label class="program-name" title={header.rename}>
      <span class="program-name__sizer" aria-hidden="true">
        {draft ?? now.name}
      </span>
      <input
        ref={input}
        class="program-name__input"
        data-testid={TEST.programName}
        aria-label={header.programName}
        maxLength={LONGEST}
        spellcheck={false}
        value={draft ?? now.name}
        onFocus={(event) => event.currentTarget.select()}
        onInput={(event) => setDraft(event.currentTarget.value)}
        onBlur={() => void finish()}
        onKeyDown={(event) => {
          if (event.key === "Escape") setDraft(null);
          if (event.key === "Enter") input.current?.blur();
        }}
      />
      <Pencil class="icon program-name__pen" aria-hidden="true" />
    </label>
  );
}
