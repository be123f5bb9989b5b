import { Camera } from "lucide-preact";
import { cameraApi } from "../api/camera";
import { texts } from "../i18n";
import { valueIn } from "../kit/requests/load_state";
import { useLoaded } from "../kit/requests/useLoaded";
import { Select } from "../kit/Select";
import { refresh } from "./sight";

const WEBCAMS = ["0", "1", "2"];

/** Selects the camera that the app uses. */
export function CameraChoice() {
  const labels = texts.value.camera;
  const status = useLoaded("camera", refresh);
  const source = valueIn(status)?.source;
  if (source === undefined) return null;
  const webcams = WEBCAMS.map((one) => [one, labels.number({ n: Number(one) + 1 })] as const);
  return (
    <Select
      class="camera-choice"
      icon={Camera}
      label={labels.choose}
      tip={labels.choose}
      testId="camera-choice"
      value={source}
      options={WEBCAMS.includes(source) ? webcams : [[source, labels.other], ...webcams]}
      onChange={async (chosen) => status.set(await cameraApi.choose(chosen))}
    />
  );
}
