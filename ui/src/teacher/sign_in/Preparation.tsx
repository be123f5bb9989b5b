import { ArrowLeft, ArrowRight } from "lucide-preact";
import { classesApi } from "../../api/classes";
import { STORE_LIMITS } from "../../api/declared";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { Field, PinField } from "../../kit/Field";
import { Form } from "../../kit/Form";
import { LinkButton } from "../../kit/LinkButton";
import { useAction } from "../../kit/requests/action";
import { FaultLine } from "../../kit/requests/FaultLine";
import { Loaded } from "../../kit/requests/Loaded";
import { useLoaded } from "../../kit/requests/useLoaded";
import { setClassroom } from "../../shell/classroom";
import { go } from "../../shell/route";
import { asTeacher, choosePin, teacherSession } from "../../shell/teacher/teacher_session";
import { useDraft } from "../useDraft";
import { ForgottenPin } from "./ForgottenPin";
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
  const { prepare: labels, door } = texts.value.teacher;
  const { busy, fault, act, refuse, clear } = useAction(asTeacher);
  const { draft, field } = useDraft(
    { pin: "", again: "", name: "", computer: known.computer },
    clear,
  );
  const submit = async () => {
    const wrong = pinFault(draft.pin, draft.again, labels);
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
        <h1>{labels.title}</h1>
        <p class="teacher__hint">{labels.hint}</p>
        <div class="sign-in__pair">
          <PinField label={labels.pin} autoFocus data-testid="pin" {...field("pin")} />
          <PinField label={labels.pinAgain} data-testid="pin-again" {...field("again")} />
          <p class="labelled__hint">{labels.pinHint}</p>
        </div>
        <Field
          label={labels.className}
          hint={labels.classHint}
          maxLength={STORE_LIMITS.MAX_NAME}
          data-testid="class-name"
          {...field("name")}
        />
        <Field
          label={labels.computer}
          hint={labels.computerHint}
          maxLength={STORE_LIMITS.MAX_NAME}
          data-testid="computer-name"
          {...field("computer")}
        />
        <FaultLine fault={fault} />
        <div class="button-row">
          <Button submit kind="main" iconEnd={ArrowRight} busy={busy} testId="prepare-done">
            {labels.done}
          </Button>
          <LinkButton kind="plain" icon={ArrowLeft} href="#/">
            {door.back}
          </LinkButton>
        </div>
        <ForgottenPin text={labels.forgotten} />
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
