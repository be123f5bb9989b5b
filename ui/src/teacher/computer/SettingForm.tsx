import { Check } from "lucide-preact";
import type { ComponentChildren } from "preact";
import { useState } from "preact/hooks";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { Form } from "../../kit/Form";
import { useAct } from "../../kit/requests/act";
import { FaultLine } from "../../kit/requests/FaultLine";
import { asTeacher } from "../../shell/teacher/teacher_session";

/** State of saving a setting, with its error. */
export function useSetting() {
  const [isKept, setKept] = useState(false);
  const { busy, fault, act, refuse, clear } = useAct(asTeacher);
  const keep = async (work: () => Promise<unknown>) => {
    const done = await act(work);
    setKept(done);
    return done;
  };
  return {
    isKept,
    busy,
    fault,
    keep,
    refuse: (message: string) => {
      setKept(false);
      refuse(message);
    },
    clear: () => {
      setKept(false);
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
  onKeep(): unknown;
  children: ComponentChildren;
}

/** Fields of one setting of this PC, and its save button. */
export function SettingForm(props: SettingFormProps) {
  const { title, setting, done, hint, buttonId, onKeep, children } = props;
  const { isKept, busy, fault } = setting;
  return (
    <Form class="panel card" onSubmit={onKeep}>
      {title && <h2>{title}</h2>}
      <div class="teacher__row">
        {children}
        <Button submit icon={Check} busy={busy} testId={buttonId}>
          {texts.value.teacher.computer.keep}
        </Button>
      </div>
      <p class={isKept ? "teacher__done" : "labelled__hint"} role="status">
        {isKept ? done : hint}
      </p>
      <FaultLine fault={fault} />
    </Form>
  );
}
