import { ArrowRight, UserRoundPlus } from "lucide-preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { api } from "../api/client";
import { enterGroup } from "../app/entering";
import { type Problem, wordsOf } from "../app/session";
import { TEST } from "../app/testids";
import { texts } from "../i18n";

const LONGEST = 60;

/** One field: type a name, press Enter. */
export function NewGroup({ first = false }: { first?: boolean }) {
  const { start } = texts.value;
  const input = useRef<HTMLInputElement>(null);
  const [busy, setBusy] = useState(false);
  const [fault, setFault] = useState<Problem | null>(null);

  useEffect(() => {
    if (first) input.current?.focus();
  }, [first]);

  const create = async (event: Event) => {
    event.preventDefault();
    const name = input.current?.value.trim() ?? "";
    if (!name) {
      setFault({ message: start.nameMissing, remedy: "" });
      input.current?.focus();
      return;
    }
    setBusy(true);
    try {
      await enterGroup(await api.createGroup(name));
    } catch (error) {
      setFault(wordsOf(error));
      setBusy(false);
      input.current?.select();
    }
  };

  return (
    <form
      class={first ? "new-group new-group--first" : "new-group card"}
      onSubmit={(event) => void create(event)}
      noValidate
    >
      {!first && (
        <h2 class="new-group__title">
          <UserRoundPlus class="icon" aria-hidden="true" />
          {start.newGroup}
        </h2>
      )}
      <input
        ref={input}
        class="field new-group__field"
        data-testid={TEST.groupName}
        aria-label={start.nameLabel}
        aria-invalid={fault !== null}
        placeholder={start.namePlaceholder}
        maxLength={LONGEST}
        autocomplete="off"
        spellcheck={false}
        onInput={() => setFault(null)}
      />
      <button
        type="submit"
        class="button button--run new-group__go"
        data-testid={TEST.createGroup}
        disabled={busy}
      >
        {busy ? start.creating : start.create}
        <ArrowRight class="icon" aria-hidden="true" />
      </button>
      {fault && (
        <p class="new-group__fault" role="alert">
          <strong>{fault.message}</strong> {fault.remedy}
        </p>
      )}
    </form>
  );
}
