import { ArrowLeft, ArrowRight } from "lucide-preact";
import { classesApi } from "../../api/classes";
import { STORE_LIMITS } from "../../api/declared";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { Field, PinField } from "../../kit/Field";
import { Form } from "../../kit/Form";
import { LinkButton } from "../../kit/LinkButton";
import { useAct } from "../../kit/requests/act";
import { FaultLine } from "../../kit/requests/FaultLine";
import { Loaded } from "../../kit/requests/Loaded";
import { useLoaded } from "../../kit/requests/useLoaded";
import { setClassroom } from "../../shell/classroom";
import { go } from "../../shell/route";
import { asTeacher, choosePin, teacherSession } from "../../shell/teacher/teacher_session";
import { useDraft } from "../useDraft";
import { pinFault } from "./pin";

interface PreparationProps {
  onDone(): void;
}

/** First set-up: PIN, class, and name of this PC. */
export function Preparation({ onDone }: PreparationProps) {
  const known = useLoaded("known", loadKnown);
  return (
    <Loaded of={known} as="screen">
      {(found) => <PreparationForm known={found} onDone={onDone} />}
    </Loaded>
  );
}

interface Known {
  computer: string;
  hasClass: boolean;
}

async function loadKnown(): Promise<Known> {
  const [computer, classes] = await Promise.all([classesApi.computer(), classesApi.classrooms()]);
  return { computer: computer.name, hasClass: classes.length > 0 };
}

function PreparationForm({ known, onDone }: PreparationProps & { known: Known }) {
  const { prepare: say, door } = texts.value.teacher;
  const { busy, fault, act, refuse, clear } = useAct(asTeacher);
  const { draft, field } = useDraft(
    { pin: "", again: "", name: "", computer: known.computer },
    clear,
  );
  const submit = async () => {
    const wrong = pinFault(draft.pin, draft.again, say);
    if (wrong) return refuse(wrong);
    if (!(await act(() => prepare(draft, known)))) return;
    onDone();
    // on further PCs the class arrives by merging
    const hasClass = known.hasClass || draft.name.trim();
    go({ screen: "teacher", part: hasClass ? "classes" : "files" });
  };
  return (
    <main class="screen sign-in">
      <Form class="sign-in__form card column gap-4" onSubmit={submit}>
        <h1>{say.title}</h1>
        <p class="teacher__hint">{say.hint}</p>
        <div class="sign-in__pair">
          <PinField label={say.pin} autoFocus data-testid="pin" {...field("pin")} />
          <PinField label={say.pinAgain} data-testid="pin-again" {...field("again")} />
          <p class="labelled__hint">{say.pinHint}</p>
        </div>
        <Field
          label={say.className}
          hint={say.classHint}
          maxLength={STORE_LIMITS.MAX_NAME}
          data-testid="class-name"
          {...field("name")}
        />
        <Field
          label={say.computer}
          hint={say.computerHint}
          maxLength={STORE_LIMITS.MAX_NAME}
          data-testid="computer-name"
          {...field("computer")}
        />
        <FaultLine fault={fault} />
        <div class="button-row">
          <Button submit kind="main" iconEnd={ArrowRight} busy={busy} testId="prepare-done">
            {say.done}
          </Button>
          <LinkButton kind="plain" icon={ArrowLeft} href="#/">
            {door.back}
          </LinkButton>
        </div>
        <p class="labelled__hint">{say.forgotten}</p>
      </Form>
    </main>
  );
}

/** Performs the steps; after a failure, a retry skips the completed ones. */
async function prepare(
  { pin, name, computer }: Record<"pin" | "name" | "computer", string>,
  known: Known,
): Promise<void> {
  if (!teacherSession.value?.is_open) await choosePin(pin);
  if (name.trim()) setClassroom((await classesApi.createClassroom(name)).id);
  if (computer.trim() && computer !== known.computer) await classesApi.renameComputer(computer);
}
