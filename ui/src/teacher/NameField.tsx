import { Check, Pencil, X } from "lucide-preact";
import type { ComponentChildren } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { LONGEST_NAME } from "../app/rename";
import { TEST } from "../app/testids";
import { useAct } from "./act";
import { FaultLine } from "./FaultLine";
import { words } from "./words";

interface NameFieldProps {
  name: string;
  /** What the pencil does, for its hint. */
  label: string;
  testId?: (typeof TEST)[keyof typeof TEST];
  onRename(name: string): Promise<unknown>;
  /** The name as it stands while nobody changes it. */
  children: ComponentChildren;
}

/** A name with a pencil: pressed, the name is a field. Enter keeps it, Escape leaves it. */
export function NameField({ name, label, testId, onRename, children }: NameFieldProps) {
  const [draft, setDraft] = useState<string | null>(null);
  const input = useRef<HTMLInputElement>(null);
  const { busy, fault, act, clear } = useAct();
  const { save, cancel } = words.value;

  useEffect(() => input.current?.select(), [draft === null]);

  if (draft === null) {
    return (
      <div class="name-field">
        {children}
        <button
          type="button"
          class="button button--plain button--icon"
          aria-label={`${label}: ${name}`}
          title={label}
          data-testid={testId}
          onClick={() => setDraft(name)}
        >
          <Pencil class="icon" aria-hidden="true" />
        </button>
      </div>
    );
  }
  const leave = () => {
    clear();
    setDraft(null);
  };
  const keep = async (event: Event) => {
    event.preventDefault();
    const wanted = draft.trim();
    if (!wanted || wanted === name) leave();
    else if (await act(() => onRename(wanted))) setDraft(null);
  };
  return (
    <form class="name-field" onSubmit={(event) => void keep(event)} noValidate>
      <input
        ref={input}
        class="field name-field__input"
        aria-label={label}
        maxLength={LONGEST_NAME}
        value={draft}
        spellcheck={false}
        data-testid={TEST.nameField}
        onInput={(event) => setDraft(event.currentTarget.value)}
        onKeyDown={(event) => event.key === "Escape" && leave()}
      />
      <button
        type="submit"
        class="button button--icon"
        aria-label={save}
        title={save}
        disabled={busy}
      >
        <Check class="icon" aria-hidden="true" />
      </button>
      <button
        type="button"
        class="button button--plain button--icon"
        aria-label={cancel}
        title={cancel}
        onClick={leave}
      >
        <X class="icon" aria-hidden="true" />
      </button>
      <FaultLine fault={fault} />
    </form>
  );
}
