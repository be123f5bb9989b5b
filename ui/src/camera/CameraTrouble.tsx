import { TriangleAlert } from "lucide-preact";
import { TEST } from "../shell/testids";
import type { CameraProblem } from "./sight";

/** Why the camera is of no use, and what to do. */
export function CameraTrouble({ problem: { code, message, remedy } }: { problem: CameraProblem }) {
  return (
    <div class="camera-trouble" role="status" data-testid={TEST.cameraTrouble} data-code={code}>
      <TriangleAlert class="icon" aria-hidden="true" />
      <p>
        <strong>{message}</strong> {remedy}
      </p>
    </div>
  );
}
