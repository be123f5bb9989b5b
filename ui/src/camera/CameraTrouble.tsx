import { TriangleAlert } from "lucide-preact";
import type { CameraProblem } from "../api/model";
import { problemText } from "./problem_text";

/** The problem of the camera, and its remedy. */
export function CameraTrouble({ problem }: { problem: CameraProblem }) {
  const { message, remedy } = problemText(problem);
  return (
    <div
      class="camera-trouble row gap-3"
      role="status"
      data-testid="camera-trouble"
      data-code={problem.code}
    >
      <TriangleAlert class="icon" aria-hidden="true" />
      <p>
        <strong>{message}</strong> {remedy}
      </p>
    </div>
  );
}
