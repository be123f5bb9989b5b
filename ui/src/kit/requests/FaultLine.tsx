import type { Problem } from "./problem";
import { Unbroken } from "./Unbroken";

interface FaultLineProps {
  fault: Problem | null;
}

/** An error and its remedy, below its field. */
export function FaultLine({ fault }: FaultLineProps) {
  if (!fault) return null;
  return (
    <p class="fault-line" role="alert">
      <strong>{fault.message}</strong> <Unbroken text={fault.remedy} />
    </p>
  );
}
