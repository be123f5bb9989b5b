import { ArrowLeft, DoorOpen } from "lucide-preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { ApiError } from "../../api/errors";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { PinField } from "../../kit/Field";
import { Form } from "../../kit/Form";
import { useAction } from "../../kit/requests/action";
import { FaultLine } from "../../kit/requests/FaultLine";
import { go } from "../../shell/route";
import { cancelWaiting, signIn } from "../../shell/teacher/teacher_session";
import { ForgottenPin } from "./ForgottenPin";

interface SignInFormProps {
  /** Whether the teacher was signed in before. */
  again: boolean;
}

/** PIN form; counts down the wait after too many wrong PINs. */
export function SignInForm({ again }: SignInFormProps) {
  const { door: labels } = texts.value.teacher;
  const place = useRef<HTMLElement>(null);
  const focusField = () => place.current?.querySelector("input")?.focus();
  const { pin, write, left, busy, fault, enter } = useSignIn(focusField);
  useEffect(focusField, []);
  return (
    <main ref={place} class="screen sign-in">
      <Form class="sign-in__form card column gap-4" onSubmit={enter}>
        <h1>{labels.title}</h1>
        <p class="teacher__hint">{again ? labels.again : labels.hint}</p>
        <PinField
          label={labels.pin}
          value={pin}
          data-testid="pin"
          aria-invalid={fault !== null}
          onText={write}
        />
        <FaultLine fault={fault} />
        {left > 0 && (
          <p class="notice-box" role="timer" data-testid="pin-wait">
            {labels.wait({ count: left })}
          </p>
        )}
        <div class="button-row">
          <Button
            submit
            kind="main"
            icon={DoorOpen}
            busy={busy}
            disabled={left > 0}
            testId="sign-in"
          >
            {labels.enter}
          </Button>
          <Button kind="plain" icon={ArrowLeft} testId="sign-in-back" onPress={goBack}>
            {labels.back}
          </Button>
        </div>
        <ForgottenPin text={labels.forgotten} />
      </Form>
    </main>
  );
}

function goBack(): void {
  cancelWaiting();
  go({ screen: "start" });
}

/** State of the PIN form; `onRefused` is called after a refused PIN. */
function useSignIn(onRefused: () => void) {
  const [pin, setPin] = useState("");
  const [left, setLeft] = useCountdown();
  const { busy, fault, act, refuse, clear } = useAction();
  const startWaiting = (error: unknown) => {
    const seconds = error instanceof ApiError ? Number(error.params.seconds) : 0;
    if (!(seconds > 0)) throw error;
    setLeft(seconds);
  };
  const enter = async () => {
    if (left > 0) return;
    if (!pin) return refuse(texts.value.teacher.door.empty);
    await act(() => signIn(pin).catch(startWaiting));
    setPin("");
    onRefused();
  };
  const write = (text: string) => {
    setPin(text);
    clear();
  };
  return { pin, write, left, busy, fault, enter };
}

/** State that counts seconds down to 0. */
function useCountdown() {
  const [left, setLeft] = useState(0);
  useEffect(() => {
    if (left === 0) return;
    const timer = setTimeout(() => setLeft(left - 1), 1000);
    return () => clearTimeout(timer);
  }, [left]);
  return [left, setLeft] as const;
}
