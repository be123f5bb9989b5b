import { Power, Save } from "lucide-preact";
import type { OverheadCamera } from "../../../api/model";
import { overheadApi } from "../../../api/real_runs";
import { language, texts } from "../../../i18n";
import { Button } from "../../../kit/Button";
import { Loaded } from "../../../kit/requests/Loaded";
import { saveFile } from "../../../shell/files/save_file";
import { asTeacher } from "../../../shell/teacher/teacher_session";
import { useTeacherLoaded } from "../../useTeacherLoaded";
import { MeasuresForm } from "./MeasuresForm";
import { Trial } from "./Trial";

/** The camera above the floor: its sheets, the measurements, a trial. Folded while there is none. */
export function OverheadPart() {
  const { overhead: labels } = texts.value;
  const camera = useTeacherLoaded("overhead", overheadApi.get);
  return (
    <details class="folded overhead" data-testid="overhead">
      <summary data-testid="overhead-open">{labels.title}</summary>
      <p class="teacher__hint">{labels.hint}</p>
      <Loaded of={camera}>{(found) => <Steps camera={found} onChanged={camera.set} />}</Loaded>
    </details>
  );
}

interface StepsProps {
  camera: OverheadCamera;
  onChanged(camera: OverheadCamera): void;
}

function Steps({ camera, onChanged }: StepsProps) {
  const { overhead: labels } = texts.value;
  return (
    <>
      <div class="row wrap middle gap-4">
        <p class="robot-form__state" data-set-up={camera.is_on} data-testid="overhead-state">
          {camera.is_on ? labels.isOn : labels.isOff}
        </p>
        {camera.is_on && (
          <Button
            icon={Power}
            testId="overhead-off"
            onPress={async () => onChanged(await asTeacher(overheadApi.switchOff))}
          >
            {labels.off}
          </Button>
        )}
      </div>
      <section class="overhead__step">
        <h3>{labels.sheets}</h3>
        <p class="teacher__hint">{labels.sheetsHint}</p>
        <Button icon={Save} testId="overhead-sheets" onPress={saveSheets}>
          {labels.saveSheets}
        </Button>
      </section>
      <MeasuresForm camera={camera} onSaved={onChanged} />
      {camera.is_on && <Trial />}
    </>
  );
}

/** Saves the sheets as a page that any browser prints, in the language of the page. */
async function saveSheets(): Promise<void> {
  const page = await asTeacher(overheadApi.sheets);
  const name = `${texts.value.overhead.fileName}.${language.value}.html`;
  saveFile(name, new Blob([page], { type: "text/html" }));
}
