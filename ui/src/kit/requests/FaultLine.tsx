import type { Problem } from "./problem";
import { Remedy } from "./Remedy";

interface FaultLineProps {
  fault: Problem | null;
}

/** An error and its remedy, below its field. */
export function FaultLine({ fault }: FaultLineProps) {
  if (!fault) return null;
  return (
    <div class="fault-line" role="alert">
      <Remedy of={fault} />
    </div>
  );
}
