import { ArrowLeft, DoorOpen } from "lucide-preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { ApiError } from "../api/errors";
import { type Problem, wordsOf } from "../app/session";
import { enterDoor } from "../app/teacher";
import { TEST } from "../app/testids";
import { FaultLine } from "./FaultLine";
import { PinField } from "./Field";
import { words } from "./words";

/** Asks for the PIN; where it was wrong too often, says how long to wait, second by second. */
export function DoorForm({ again }: { again: boolean }) {
  const { door } = words.value;
  const form = useRef<HTMLFormElement>(null);
  const [pin, setPin] = useState("");
  const [busy, setBusy] = useState(false);
  const [fault, setFault] = useState<Problem | null>(null);
  const [left, setLeft] = useState(0);
  const toField = () => form.current?.querySelector("input")?.focus();

  useEffect(toField, []);
  useEffect(() => {
    if (left === 0) return;
    const timer = setTimeout(() => setLeft(left - 1), 1000);
    return () => clearTimeout(timer);
  }, [left]);

  const enter = async (event: Event) => {
    event.preventDefault();
    if (left > 0) return;
    if (!pin) {
      setFault({ message: door.empty, remedy: "" });
      return;
    }
    setBusy(true);
    setFault(null);
    try {
      await enterDoor(pin);
    } catch (error) {
      const seconds = error instanceof ApiError ? Number(error.params.seconds) : 0;
      if (seconds > 0) setLeft(seconds);
      else setFault(wordsOf(error));
      setPin("");
      toField();
    } finally {
      setBusy(false);
    }
  };

  return (
    <main class="screen teacher-door">
      <form
        ref={form}
        class="teacher-door__form card"
        onSubmit={(event) => void enter(event)}
        noValidate
      >
        <h1>{door.title}</h1>
        <p class="teacher__hint">{again ? door.again : door.hint}</p>
        <PinField
          label={door.pin}
          value={pin}
          data-testid={TEST.pin}
          aria-invalid={fault !== null}
          onText={(text) => {
            setPin(text);
            setFault(null);
          }}
        />
        <FaultLine fault={fault} />
        {left > 0 && (
          <p class="teacher__wait" role="timer" data-testid={TEST.pinWait}>
            {door.wait(left)}
          </p>
        )}
        <div class="teacher__buttons">
          <button
            type="submit"
            class="button button--run"
            disabled={busy || left > 0}
            data-testid={TEST.enterDoor}
          >
            <DoorOpen class="icon" aria-hidden="true" />
            {door.enter}
          </button>
          <a class="button button--plain" href="#/">
            <ArrowLeft class="icon" aria-hidden="true" />
            {door.back}
          </a>
        </div>
        <p class="labelled__hint">{door.forgotten}</p>
      </form>
    </main>
  );
}
