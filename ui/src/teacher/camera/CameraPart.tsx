import { CircleCheck, CircleDashed, TriangleAlert } from "lucide-preact";
import { CameraChoice } from "../../camera/CameraChoice";
import { CameraPicture } from "../../camera/CameraPicture";
import { NowSeen } from "../../camera/NowSeen";
import { texts } from "../../i18n";
import { useInstance } from "../../kit/instance";
import { CameraCheck, type Finding, POINTS, type Point } from "./camera_check";

/** The teacher tries the camera before a lesson: what it sees, and whether it serves. It is on while this is shown. */
export function CameraPart() {
  const check = useInstance(() => new CameraCheck());
  const { camera: say } = texts.value.teacher;
  return (
    <>
      <div class="row wrap top apart gap-3">
        <h1>{say.title}</h1>
        <CameraChoice />
      </div>
      <p class="teacher__hint">{say.hint}</p>
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
                finding={check.findings.value[point]}
                sign={check.sign.value}
              />
            ))}
          </ul>
          <div class="camera-try__seen card">
            <NowSeen progress={0} />
          </div>
        </div>
      </div>
      <section class="panel card">
        <h2>{say.before}</h2>
        <ul class="camera-try__advice">
          {say.advice.map((line) => (
            <li key={line}>{line}</li>
          ))}
        </ul>
      </section>
    </>
  );
}

function Ready({ isReady }: { isReady: boolean }) {
  const { camera: say } = texts.value.teacher;
  return (
    <p class="camera-try__ready" role="status" data-testid="camera-ready" data-ready={isReady}>
      {isReady ? say.ready : say.notReady}
    </p>
  );
}

interface FoundProps {
  point: Point;
  finding: Finding;
  sign: string;
}

function Found({ point, finding, sign }: FoundProps) {
  const { points, seen } = texts.value.teacher.camera;
  const Icon = finding === "good" ? CircleCheck : finding === "open" ? CircleDashed : TriangleAlert;
  const words: Partial<Record<Finding, string>> = points[point];
  return (
    <li
      class="camera-try__point row middle gap-3"
      data-testid="camera-point"
      data-name={point}
      data-finding={finding}
    >
      <Icon class="icon" aria-hidden="true" />
      {point === "sign" && sign ? seen(sign) : words[finding]}
    </li>
  );
}
