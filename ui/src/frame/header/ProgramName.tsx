import { Pencil } from "lucide-preact";
import { useRef, useState } from "preact/hooks";
import { LONGEST_NAME, renameProgram } from "../app/rename";
import { route } from "../app/route";
import { program } from "../app/session";
import { TEST } from "../app/testids";
import { texts } from "../i18n";

/** The program's name, changed where it stands: type, then Enter or go elsewhere; Escape takes it back. */
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
    <label class="program-name" title={header.rename}>
      <span class="program-name__sizer" aria-hidden="true">
        {draft ?? now.name}
      </span>
      <input
        ref={input}
        class="program-name__input"
        data-testid={TEST.programName}
        aria-label={header.programName}
        maxLength={LONGEST_NAME}
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
