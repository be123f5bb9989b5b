import { Plus } from "lucide-preact";
import { useState } from "preact/hooks";
import { LONGEST_NAME } from "../app/rename";
import type { TEST } from "../app/testids";
import { useAct } from "./act";
import { FaultLine } from "./FaultLine";
import { words } from "./words";

type TestId = (typeof TEST)[keyof typeof TEST];

interface AddFormProps {
  label: string;
  placeholder: string;
  fieldId: TestId;
  buttonId: TestId;
  onAdd(name: string): Promise<unknown>;
}

/** A name, and one more of its kind. */
export function AddForm({ label, placeholder, fieldId, buttonId, onAdd }: AddFormProps) {
  const [name, setName] = useState("");
  const { busy, fault, act, refuse, clear } = useAct();
  const { classes } = words.value;

  const add = async (event: Event) => {
    event.preventDefault();
    const wanted = name.trim();
    if (!wanted) refuse(classes.nameMissing);
    else if (await act(() => onAdd(wanted))) setName("");
  };

  return (
    <form class="add-form" onSubmit={(event) => void add(event)} noValidate>
      <input
        class="field"
        aria-label={label}
        placeholder={placeholder}
        maxLength={LONGEST_NAME}
        autocomplete="off"
        spellcheck={false}
        value={name}
        data-testid={fieldId}
        onInput={(event) => {
          clear();
          setName(event.currentTarget.value);
        }}
      />
      <button type="submit" class="button" disabled={busy} data-testid={buttonId}>
        <Plus class="icon" aria-hidden="true" />
        {classes.make}
      </button>
      <FaultLine fault={fault} />
    </form>
  );
}
