import { ProblemText } from "./ProblemText";
import type { Problem } from "./problem";

interface FaultLineProps {
  fault: Problem | null;
}

/** An error and its remedy, below its field. */
export function FaultLine({ fault }: FaultLineProps) {
  if (!fault) return null;
  return (
    <div class="fault-line" role="alert">
      <ProblemText of={fault} />
    </div>
  );
}
