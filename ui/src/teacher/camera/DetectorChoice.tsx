import { FileUp, Hand, Trash2 } from "lucide-preact";
import { recognizersApi } from "../../api/camera";
import type { Recognizers } from "../../api/model";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { useAction } from "../../kit/requests/action";
import { FaultLine } from "../../kit/requests/FaultLine";
import { Loaded } from "../../kit/requests/Loaded";
import { useLoaded } from "../../kit/requests/useLoaded";
import { Select } from "../../kit/Select";
import { FileButton } from "../../shell/files/FileButton";
import { asTeacher } from "../../shell/teacher/teacher_session";

const LANDMARKS = "";

/** What reads the signs on this PC: the hands' landmarks, or a detector that the teacher adds as a file. */
export function DetectorChoice() {
  const { detector: labels } = texts.value.teacher.camera;
  const found = useLoaded("recognizers", () => asTeacher(recognizersApi.list));
  return (
    <section class="panel card column gap-3" aria-labelledby="detector-title">
      <h2 id="detector-title">{labels.title}</h2>
      <p class="labelled__hint">{labels.hint}</p>
      <Loaded of={found}>{(known) => <Choice known={known} onChange={found.set} />}</Loaded>
    </section>
  );
}

interface ChoiceProps {
  known: Recognizers;
  onChange(known: Recognizers): void;
}

function Choice({ known, onChange }: ChoiceProps) {
  const { detector: labels } = texts.value.teacher.camera;
  const { busy, fault, act } = useAction(asTeacher);
  const change = (ask: () => Promise<Recognizers>) => act(async () => onChange(await ask()));
  const { chosen, detectors, of_command: command } = known;
  // the file of the chosen one may be gone
  const names = [...new Set([...detectors, chosen])].filter(Boolean);
  if (command !== null)
    return <p data-testid="detector-of-command">{labels.byCommand({ command })}</p>;
  return (
    <>
      <div class="button-row">
        <Select
          icon={Hand}
          label={labels.title}
          testId="detector-choice"
          value={chosen}
          options={[[LANDMARKS, labels.landmarks], ...names.map((one) => [one, one] as const)]}
          onChange={(name) => change(() => recognizersApi.choose(name))}
        />
        <FileButton
          accept=".onnx"
          icon={FileUp}
          testId="detector-file"
          onFile={(file) => change(() => recognizersApi.add(file))}
        >
          {labels.add}
        </FileButton>
        {detectors.includes(chosen) && (
          <Button
            kind="plain"
            icon={Trash2}
            busy={busy}
            testId="detector-remove"
            onPress={() => change(() => recognizersApi.remove(chosen))}
          >
            {labels.remove({ name: chosen })}
          </Button>
        )}
      </div>
      {busy && <p role="status">{labels.loading}</p>}
      <FaultLine fault={fault ?? known.problem} />
      {known.in_use !== LANDMARKS && (
        <p data-testid="detector-signs">{labels.signs({ signs: known.signs.join(", ") })}</p>
      )}
    </>
  );
}
