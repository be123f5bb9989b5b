import { Check } from "lucide-preact";
import { useEffect, useState } from "preact/hooks";
import { classesApi } from "../api/classes";
import { report } from "../app/session";
import { choosePin } from "../app/teacher";
import { TEST } from "../app/testids";
import { setTurnMinutes, TURN_MINUTES, turnMinutes } from "../app/turns";
import { useAct } from "./act";
import { FaultLine } from "./FaultLine";
import { Field, PinField } from "./Field";
import { pinFault } from "./pin";
import { words } from "./words";

/** What holds for this PC: its name, the PIN, taking turns. */
export function ComputerPart() {
  return (
    <>
      <h1>{words.value.computer.title}</h1>
      <ComputerName />
      <NewPin />
      <Turns />
    </>
  );
}

function ComputerName() {
  const { computer: say } = words.value;
  const [name, setName] = useState("");
  const [kept, setKept] = useState(false);
  const { busy, fault, act } = useAct();
  useEffect(() => {
    classesApi.computer().then((here) => setName(here.name), report);
  }, []);
  const keep = async (event: Event) => {
    event.preventDefault();
    setKept(await act(() => classesApi.renameComputer(name)));
  };
  return (
    <form class="panel card" onSubmit={(event) => void keep(event)} noValidate>
      <div class="teacher__row">
        <Field
          label={say.name}
          value={name}
          maxLength={60}
          data-testid={TEST.computerName}
          onText={(text) => {
            setKept(false);
            setName(text);
          }}
        />
        <Keep busy={busy} testId={TEST.keepComputer} />
      </div>
      <Said words={kept ? say.kept : ""} otherwise={say.nameHint} />
      <FaultLine fault={fault} />
    </form>
  );
}

function NewPin() {
  const { computer: say, prepare } = words.value;
  const [pin, setPin] = useState("");
  const [again, setAgain] = useState("");
  const [kept, setKept] = useState(false);
  const { busy, fault, act, refuse, clear } = useAct();
  const keep = async (event: Event) => {
    event.preventDefault();
    setKept(false);
    const wrong = pinFault(pin, again, prepare);
    if (wrong) return refuse(wrong);
    if (!(await act(() => choosePin(pin)))) return;
    setKept(true);
    setPin("");
    setAgain("");
  };
  const onText = (set: (text: string) => void) => (text: string) => {
    clear();
    setKept(false);
    set(text);
  };
  return (
    <form class="panel card" onSubmit={(event) => void keep(event)} noValidate>
      <h2>{say.pin}</h2>
      <div class="teacher__row">
        <PinField
          label={say.newPin}
          value={pin}
          data-testid={TEST.newPin}
          onText={onText(setPin)}
        />
        <PinField
          label={say.newPinAgain}
          value={again}
          data-testid={TEST.newPinAgain}
          onText={onText(setAgain)}
        />
        <Keep busy={busy} testId={TEST.keepPin} />
      </div>
      <Said words={kept ? say.pinKept : ""} otherwise={prepare.pinHint} />
      <FaultLine fault={fault} />
    </form>
  );
}

function Turns() {
  const { computer: say } = words.value;
  return (
    <section class="panel card">
      <fieldset class="turn-choice">
        <legend>
          <h2>{say.turns}</h2>
        </legend>
        {TURN_MINUTES.map((minutes) => (
          <label
            key={minutes}
            class="turn-choice__one"
            data-testid={TEST.swapEvery}
            data-minutes={minutes}
          >
            <input
              type="radio"
              name="turns"
              checked={turnMinutes.value === minutes}
              onChange={() => setTurnMinutes(minutes)}
            />
            {minutes === 0 ? say.never : say.every(minutes)}
          </label>
        ))}
      </fieldset>
      <p class="labelled__hint">{say.turnsHint}</p>
    </section>
  );
}

function Keep({ busy, testId }: { busy: boolean; testId: string }) {
  return (
    <button type="submit" class="button" disabled={busy} data-testid={testId}>
      <Check class="icon" aria-hidden="true" />
      {words.value.computer.keep}
    </button>
  );
}

/** That it was done, where the hint stood. */
function Said({ words: done, otherwise }: { words: string; otherwise: string }) {
  return (
    <p class={done ? "teacher__done" : "labelled__hint"} role="status">
      {done || otherwise}
    </p>
  );
}
