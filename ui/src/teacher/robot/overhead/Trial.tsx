import { type Signal, useSignal } from "@preact/signals";
import { CircleCheck, CircleDashed, ScanSearch, Square } from "lucide-preact";
import { useEffect } from "preact/hooks";
import type { OverheadSighting } from "../../../api/model";
import { overheadApi } from "../../../api/real_runs";
import { CameraChoice } from "../../../camera/CameraChoice";
import { CameraPicture } from "../../../camera/CameraPicture";
import { texts } from "../../../i18n";
import { Button } from "../../../kit/Button";
import { usePolling } from "../../../kit/usePolling";
import { asTeacher } from "../../../shell/teacher/teacher_session";
import { MarkersPicture } from "./MarkersPicture";

const ASK_EACH_MS = 700;
const SHEETS = [1, 2, 3, 4, 5] as const;

/** Chooses the camera, and shows what it sees. */
export function Trial() {
  const { overhead: labels } = texts.value;
  const isOn = useSignal(false);
  const toggle = () => {
    isOn.value = !isOn.value;
  };
  return (
    <section class="overhead__step">
      <h3>{labels.trial}</h3>
      <p class="teacher__hint">{labels.trialHint}</p>
      <div class="row wrap middle gap-3">
        <CameraChoice />
        <Button
          icon={isOn.value ? Square : ScanSearch}
          pressed={isOn.value}
          testId="overhead-try"
          onPress={toggle}
        >
          {isOn.value ? labels.stop : labels.tryOut}
        </Button>
      </div>
      {isOn.value && <Sightings />}
    </section>
  );
}

/** The picture and what is found in it, while it is shown. */
function Sightings() {
  const sighting = useSignal<OverheadSighting | null>(null);
  useTrial(sighting);
  const { value: found } = sighting;
  const markers = found?.markers ?? [];
  return (
    <div class="overhead__trial">
      <div class="overhead__picture">
        <CameraPicture />
      </div>
      <div class="column gap-2">
        <MarkersPicture seen={markers} />
        <ul class="overhead__sheets">
          {SHEETS.map((n) => (
            <Sheet key={n} n={n} isFound={markers.includes(n)} />
          ))}
        </ul>
        <p
          role="status"
          class="overhead__found"
          data-testid="overhead-found"
          data-code={found?.code}
        >
          {found?.code ? `${found.message} ${found.remedy}` : texts.value.overhead.starting}
        </p>
      </div>
    </div>
  );
}

/** Asks repeatedly: each request keeps the camera on for some seconds. */
function useTrial(sighting: Signal<OverheadSighting | null>): void {
  const ask = async () => {
    sighting.value = await asTeacher(overheadApi.tryOut);
  };
  useEffect(() => {
    void ask().catch(() => {}); // asked again
    return () => void overheadApi.endTrial().catch(() => {}); // ends by itself, too
  }, []);
  usePolling(() => ask().catch(() => {}), { everyMs: ASK_EACH_MS });
}

function Sheet({ n, isFound }: { n: number; isFound: boolean }) {
  const { overhead: labels } = texts.value;
  const Icon = isFound ? CircleCheck : CircleDashed;
  return (
    <li class="row middle gap-2" data-testid="overhead-sheet" data-sheet={n} data-seen={isFound}>
      <Icon class="icon" aria-hidden="true" />
      {isFound ? labels.seen({ n }) : labels.unseen({ n })}
    </li>
  );
}
