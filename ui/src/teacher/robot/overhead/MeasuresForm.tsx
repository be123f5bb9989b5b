import { Check } from "lucide-preact";
import { useState } from "preact/hooks";
import type { OverheadCamera } from "../../../api/model";
import { overheadApi } from "../../../api/real_runs";
import { language, texts } from "../../../i18n";
import { Button } from "../../../kit/Button";
import { Field } from "../../../kit/Field";
import { Form } from "../../../kit/Form";
import { numberIn } from "../../../kit/NumberField";
import { useAction } from "../../../kit/requests/action";
import { FaultLine } from "../../../kit/requests/FaultLine";
import { asTeacher } from "../../../shell/teacher/teacher_session";
import { useDraft } from "../../useDraft";
import { MarkersPicture } from "./MarkersPicture";

const MEASURES = ["width", "depth", "camera", "robot"] as const;
type Measure = (typeof MEASURES)[number];

interface MeasuresFormProps {
  camera: OverheadCamera;
  onSaved(camera: OverheadCamera): void;
}

/** What the teacher measures: where the sheets lie, and the two heights. */
export function MeasuresForm({ camera, onSaved }: MeasuresFormProps) {
  const { overhead: labels } = texts.value;
  const [isSaved, setSaved] = useState(false);
  const { busy, fault, act, refuse, clear } = useAction(asTeacher);
  const { draft, field } = useDraft<Measure>(draftOf(camera), () => {
    setSaved(false);
    clear();
  });
  const save = async () => {
    const [width_m, depth_m, camera_m, robot_m] = MEASURES.map((name) => numberIn(draft[name]));
    if (width_m == null || depth_m == null || camera_m == null || robot_m == null)
      return refuse(labels.notNumber);
    const measures = { width_m, depth_m, camera_m, robot_m };
    setSaved(await act(async () => onSaved(await overheadApi.save(measures))));
  };
  return (
    <Form class="overhead__step" onSubmit={save}>
      <h3>{labels.measures}</h3>
      <p class="teacher__hint">{labels.measuresHint}</p>
      <div class="overhead__measures">
        <MarkersPicture />
        <div class="robot-form__part">
          {MEASURES.map((name) => (
            <Field
              key={name}
              label={labels[name]}
              maxLength={10}
              inputMode="decimal"
              data-testid="overhead-measure"
              data-name={name}
              {...field(name)}
            />
          ))}
        </div>
      </div>
      <Button submit kind="main" icon={Check} busy={busy} testId="overhead-save">
        {labels.save}
      </Button>
      <p class="teacher__done" role="status">
        {isSaved && labels.saved}
      </p>
      <FaultLine fault={fault} />
    </Form>
  );
}

function draftOf(camera: OverheadCamera): Record<Measure, string> {
  const written = (metres: number) =>
    metres.toLocaleString(language.value, { maximumFractionDigits: 3, useGrouping: false });
  return {
    width: written(camera.width_m),
    depth: written(camera.depth_m),
    camera: written(camera.camera_m),
    robot: written(camera.robot_m),
  };
}
