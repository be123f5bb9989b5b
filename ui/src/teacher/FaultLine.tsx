import type { Problem } from "../app/session";

/** What went wrong and what to do, below the field that it is about. */
export function FaultLine({ fault }: { fault: Problem | null }) {
  if (!fault) return null;
  return (
    <p class="teacher__fault" role="alert">
      <strong>{fault.message}</strong> {fault.remedy}
    </p>
  );
}
