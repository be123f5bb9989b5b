import { Check } from "lucide-preact";
import type { ComponentChildren } from "preact";
import { useState } from "preact/hooks";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { Form } from "../../kit/Form";
import { useAction } from "../../kit/requests/action";
import { FaultLine } from "../../kit/requests/FaultLine";
import { asTeacher } from "../../shell/teacher/teacher_session";

/** State of saving a setting, with its error. */
export function useSetting() {
  const [isSaved, setSaved] = useState(false);
  const { busy, fault, act, refuse, clear } = useAction(asTeacher);
  const save = async (work: () => Promise<unknown>) => {
    const done = await act(work);
    setSaved(done);
    return done;
  };
  return {
    isSaved,
    busy,
    fault,
    save,
    refuse: (message: string) => {
      setSaved(false);
      refuse(message);
    },
    clear: () => {
      setSaved(false);
      clear();
    },
  };
}

interface SettingFormProps {
  title?: string;
  setting: ReturnType<typeof useSetting>;
  /** Replaces the hint after saving. */
  done: string;
  hint: string;
  buttonId: string;
  onSave(): unknown;
  children: ComponentChildren;
}

/** Fields of one setting of this PC, and its save button. */
export function SettingForm(props: SettingFormProps) {
  const { title, setting, done, hint, buttonId, onSave, children } = props;
  const { isSaved, busy, fault } = setting;
  return (
    <Form class="panel card" onSubmit={onSave}>
      {title && <h2>{title}</h2>}
      <div class="teacher__row">
        {children}
        <Button submit icon={Check} busy={busy} testId={buttonId}>
          {texts.value.teacher.computer.keep}
        </Button>
      </div>
      <p class={isSaved ? "teacher__done" : "labelled__hint"} role="status">
        {isSaved ? done : hint}
      </p>
      <FaultLine fault={fault} />
    </Form>
  );
}
