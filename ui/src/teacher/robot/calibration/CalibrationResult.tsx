import { useSignal } from "@preact/signals";
import { Save } from "lucide-preact";
import { calibrationApi } from "../../../api/calibration";
import type { Calibration } from "../../../api/model";
import { language, texts } from "../../../i18n";
import { Button } from "../../../kit/Button";
import { Field } from "../../../kit/Field";
import { Form } from "../../../kit/Form";
import { useAction } from "../../../kit/requests/action";
import { FaultLine } from "../../../kit/requests/FaultLine";
import { asTeacher } from "../../../shell/teacher/teacher_session";
import { findings, heldOutText, interval, squaresText, unknowns } from "./calibration_texts";

interface CalibrationResultProps {
  of: Calibration;
  onSaved(): Promise<void>;
}

/** What runs tell about a real robot, in words, and the form that keeps it as a robot of the simulator. */
export function CalibrationResult({ of: found, onSaved }: CalibrationResultProps) {
  const { calibration: labels } = texts.value;
  const missing = unknowns(found, labels);
  return (
    <section class="panel card calibration__result" data-testid="calibration-result">
      <h3>{labels.found}</h3>
      <ul>
        {findings(found, labels, language.value).map((one) => (
          <li key={one}>{one}</li>
        ))}
      </ul>
      {missing.length > 0 && (
        <p class="notice-box" data-testid="calibration-unknown">
          {labels.unknown({ names: missing.join(", ") })}
        </p>
      )}
      <p data-testid="calibration-held-out">
        {heldOutText(found, labels, language.value) ?? labels.notHeldOut}
      </p>
      {found.squares && (
        <p data-testid="calibration-squares">
          {squaresText(found.squares, labels, language.value)}
        </p>
      )}
      <Details of={found} />
      <SaveForm runs={found.runs} onSaved={onSaved} />
    </section>
  );
}

function Details({ of: found }: { of: Calibration }) {
  const { calibration: labels } = texts.value;
  return (
    <details class="folded">
      <summary>{labels.details}</summary>
      <dl class="calibration__parameters">
        {found.parameters
          .filter((one) => one.is_known)
          .map((one) => (
            <>
              <dt>{labels.parameters[one.name as keyof typeof labels.parameters] ?? one.name}</dt>
              <dd>{interval(one, labels, language.value)}</dd>
            </>
          ))}
      </dl>
    </details>
  );
}

function SaveForm({ runs, onSaved }: { runs: string[]; onSaved(): Promise<void> }) {
  const { calibration: labels } = texts.value;
  const title = useSignal("");
  const isSaved = useSignal(false);
  const { busy, fault, act } = useAction(asTeacher);
  if (isSaved.value)
    return (
      <p role="status" data-testid="calibrated-saved">
        {labels.saved({ title: title.value })}
      </p>
    );
  const save = async () => {
    if (!(await act(() => calibrationApi.save(runs, title.value)))) return;
    isSaved.value = true;
    await onSaved();
  };
  return (
    <Form class="teacher__row" testId="calibration-form" onSubmit={save}>
      <Field
        label={labels.name}
        value={title.value}
        placeholder={labels.example}
        data-testid="calibration-name"
        onText={(text) => {
          title.value = text;
        }}
      />
      <Button submit kind="main" icon={Save} busy={busy} testId="calibration-save">
        {labels.save}
      </Button>
      <FaultLine fault={fault} />
    </Form>
  );
}
