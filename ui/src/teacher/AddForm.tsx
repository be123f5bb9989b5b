import { Plus } from "lucide-preact";
import { useState } from "preact/hooks";
import { STORE_LIMITS } from "../api/declared";
import { texts } from "../i18n";
import { Button } from "../kit/Button";
import { Form } from "../kit/Form";
import { useAction } from "../kit/requests/action";
import { FaultLine } from "../kit/requests/FaultLine";
import { asTeacher } from "../shell/teacher/teacher_session";

interface AddFormProps {
  label: string;
  placeholder: string;
  fieldId: string;
  buttonId: string;
  onAdd(name: string): Promise<unknown>;
}

/** A field for a name, and a button that adds an entry of that name. */
export function AddForm({ label, placeholder, fieldId, buttonId, onAdd }: AddFormProps) {
  const [name, setName] = useState("");
  const { busy, fault, act, refuse, clear } = useAction(asTeacher);
  const { classes } = texts.value.teacher;

  const add = async () => {
    const trimmedName = name.trim();
    if (!trimmedName) refuse(classes.nameMissing);
    else if (await act(() => onAdd(trimmedName))) setName("");
  };

  return (
    <Form class="add-form row wrap gap-2" onSubmit={add}>
      <input
        class="field"
        aria-label={label}
        placeholder={placeholder}
        maxLength={STORE_LIMITS.MAX_NAME}
        autocomplete="off"
        spellcheck={false}
        value={name}
        data-testid={fieldId}
        onInput={(event) => {
          clear();
          setName(event.currentTarget.value);
        }}
      />
      <Button submit icon={Plus} busy={busy} testId={buttonId}>
        {classes.make}
      </Button>
      <FaultLine fault={fault} />
    </Form>
  );
}
