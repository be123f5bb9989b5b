import { ArrowLeft, ArrowRight } from "lucide-preact";
import { useEffect, useState } from "preact/hooks";
import { classesApi } from "../api/classes";
import { setClassroom } from "../app/classroom";
import { go } from "../app/route";
import { report } from "../app/session";
import { choosePin, door } from "../app/teacher";
import { TEST } from "../app/testids";
import { useAct } from "./act";
import { FaultLine } from "./FaultLine";
import { Field, PinField } from "./Field";
import { pinFault } from "./pin";
import { words } from "./words";

/** The first day: a PIN, a class, and what this PC is called. */
export function Preparation({ onDone }: { onDone(): void }) {
  const { prepare, door: doorWords } = words.value;
  const [pin, setPin] = useState("");
  const [again, setAgain] = useState("");
  const [name, setName] = useState("");
  const [computer, setComputer] = useState("");
  const [known, setKnown] = useState("");
  const [hasClass, setHasClass] = useState(false);
  const { busy, fault, act, refuse, clear } = useAct();

  useEffect(() => {
    const load = async () => {
      const [here, classes] = await Promise.all([classesApi.computer(), classesApi.classrooms()]);
      setKnown(here.name);
      setComputer((now) => now || here.name);
      setHasClass(classes.length > 0);
    };
    load().catch(report);
  }, []);

  const done = async () => {
    // what is done already is not done again after something else was refused
    if (!door.value?.is_open) await choosePin(pin);
    if (name.trim()) setClassroom((await classesApi.createClassroom(name)).id);
    if (computer.trim() && computer !== known) await classesApi.renameComputer(computer);
  };

  const submit = async (event: Event) => {
    event.preventDefault();
    const wrong = pinFault(pin, again, prepare);
    if (wrong) refuse(wrong);
    else if (await act(done)) {
      onDone();
      // a class that was not made here comes by stick
      go({ screen: "teacher", part: hasClass || name.trim() ? "classes" : "files" });
    }
  };

  const onText = (set: (text: string) => void) => (text: string) => {
    clear();
    set(text);
  };
  return (
    <main class="screen teacher-door">
      <form class="teacher-door__form card" onSubmit={(event) => void submit(event)} noValidate>
        <h1>{prepare.title}</h1>
        <p class="teacher__hint">{prepare.hint}</p>
        <div class="teacher__pair">
          <PinField
            label={prepare.pin}
            value={pin}
            autoFocus
            data-testid={TEST.pin}
            onText={onText(setPin)}
          />
          <PinField
            label={prepare.pinAgain}
            value={again}
            data-testid={TEST.pinAgain}
            onText={onText(setAgain)}
          />
          <p class="labelled__hint">{prepare.pinHint}</p>
        </div>
        <Field
          label={prepare.className}
          hint={prepare.classHint}
          value={name}
          maxLength={60}
          data-testid={TEST.className}
          onText={onText(setName)}
        />
        <Field
          label={prepare.computer}
          hint={prepare.computerHint}
          value={computer}
          maxLength={60}
          data-testid={TEST.computerName}
          onText={onText(setComputer)}
        />
        <FaultLine fault={fault} />
        <div class="teacher__buttons">
          <button
            type="submit"
            class="button button--run"
            disabled={busy}
            data-testid={TEST.prepareDone}
          >
            {prepare.done}
            <ArrowRight class="icon" aria-hidden="true" />
          </button>
          <a class="button button--plain" href="#/">
            <ArrowLeft class="icon" aria-hidden="true" />
            {doorWords.back}
          </a>
        </div>
        <p class="labelled__hint">{prepare.forgotten}</p>
      </form>
    </main>
  );
}
