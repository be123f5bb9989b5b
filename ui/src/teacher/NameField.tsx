import { Check, Pencil, X } from "lucide-preact";
import type { ComponentChildren } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { STORE_LIMITS } from "../api/declared";
import { texts } from "../i18n";
import { labelled } from "../i18n/phrases";
import { Button } from "../kit/Button";
import { Form } from "../kit/Form";
import { useAction } from "../kit/requests/action";
import { FaultLine } from "../kit/requests/FaultLine";
import { asTeacher } from "../shell/teacher/teacher_session";

interface NameFieldProps {
  name: string;
  /** Tooltip of the pencil. */
  label: string;
  testId?: string;
  onRename(name: string): Promise<unknown>;
  /** Display of the name while it is not edited. */
  children: ComponentChildren;
}

/** A name with a button that turns it into a field. Enter saves the new name, Escape discards it. */
export function NameField({ name, label, testId, onRename, children }: NameFieldProps) {
  const [draft, setDraft] = useState<string | null>(null);
  const input = useRef<HTMLInputElement>(null);
  const { busy, fault, act, clear } = useAction(asTeacher);
  const { save, cancel } = texts.value.teacher;
  useEffect(() => input.current?.select(), [draft === null]);
  const leave = () => {
    clear();
    setDraft(null);
  };
  const submit = async (newName: string) => {
    if (!newName || newName === name) leave();
    else if (await act(() => onRename(newName))) setDraft(null);
  };
  if (draft === null) {
    return (
      <div class="name-field row wrap middle shrinks gap-1">
        {children}
        <Button
          kind="plain"
          icon={Pencil}
          label={labelled(label, name)}
          tip={label}
          testId={testId}
          onPress={() => setDraft(name)}
        />
      </div>
    );
  }
  return (
    <Form class="name-field row wrap middle shrinks gap-1" onSubmit={() => submit(draft.trim())}>
      <input
        ref={input}
        class="field name-field__input"
        aria-label={label}
        maxLength={STORE_LIMITS.MAX_NAME}
        value={draft}
        spellcheck={false}
        data-testid="name-field"
        onInput={(event) => setDraft(event.currentTarget.value)}
        onKeyDown={(event) => event.key === "Escape" && leave()}
      />
      <Button submit icon={Check} label={save} busy={busy} />
      <Button kind="plain" icon={X} label={cancel} onPress={leave} />
      <FaultLine fault={fault} />
    </Form>
  );
}
