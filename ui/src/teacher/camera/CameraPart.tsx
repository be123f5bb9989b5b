import { CircleCheck, CircleDashed, TriangleAlert } from "lucide-preact";
import { CameraChoice } from "../../camera/CameraChoice";
import { CameraPicture } from "../../camera/CameraPicture";
import { CurrentSign } from "../../camera/CurrentSign";
import { texts } from "../../i18n";
import { useInstance } from "../../kit/instance";
import { CameraCheck, POINTS, type Point, type PointStatus } from "./camera_check";
import { DetectorChoice } from "./DetectorChoice";

/**
 * Camera check before a lesson: the picture, and whether it is good enough. The camera is on while
 * this part is shown.
 */
export function CameraPart() {
  const check = useInstance(() => new CameraCheck());
  const { camera: labels } = texts.value.teacher;
  return (
    <>
      <div class="row wrap top apart gap-3">
        <h1>{labels.title}</h1>
        <CameraChoice />
      </div>
      <p class="teacher__hint">{labels.hint}</p>
      <div class="camera-try">
        <div class="camera-try__picture">
          <CameraPicture />
        </div>
        <div class="column shrinks gap-3">
          <Ready isReady={check.isReady.value} />
          <ul class="column">
            {POINTS.map((point) => (
              <Found
                key={point}
                point={point}
                status={check.statuses.value[point]}
                sign={check.sign.value}
              />
            ))}
          </ul>
          <div class="camera-try__seen card">
            <CurrentSign progress={0} />
          </div>
        </div>
      </div>
      <section class="panel card">
        <h2>{labels.before}</h2>
        <ul class="camera-try__advice">
          {labels.advice.map((line) => (
            <li key={line}>{line}</li>
          ))}
        </ul>
      </section>
      <DetectorChoice />
    </>
  );
}

function Ready({ isReady }: { isReady: boolean }) {
  const { camera: labels } = texts.value.teacher;
  return (
    <p class="camera-try__ready" role="status" data-testid="camera-ready" data-ready={isReady}>
      {isReady ? labels.ready : labels.notReady}
    </p>
  );
}

interface FoundProps {
  point: Point;
  status: PointStatus;
  sign: string;
}

function Found({ point, status, sign }: FoundProps) {
  const { points, seen } = texts.value.teacher.camera;
  const Icon = status === "good" ? CircleCheck : status === "open" ? CircleDashed : TriangleAlert;
  const labels: Partial<Record<PointStatus, string>> = points[point];
  return (
    <li
      class="camera-try__point row middle gap-3"
      data-testid="camera-point"
      data-name={point}
      data-finding={status}
    >
      <Icon class="icon" aria-hidden="true" />
      {point === "sign" && sign ? seen({ sign }) : labels[status]}
    </li>
  );
}
