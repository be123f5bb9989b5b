import { type ReadonlySignal, useComputed } from "@preact/signals";
import type { RunView } from "./reducer";
import { Talk } from "./Talk";
import { Watch } from "./Watch";

/** Under the floor: what the robot says, and what its variables hold. Nothing where there is neither. */
export function Shown({ view }: { view: ReadonlySignal<RunView> }) {
  const talk = useComputed(() => view.value.output.talk);
  const variables = useComputed(() => view.value.output.variables);
  const rows = Object.entries(variables.value);
  if (talk.value.length === 0 && rows.length === 0) return null;
  return (
    <div class="shown">
      {talk.value.length > 0 && <Talk lines={talk.value} />}
      {rows.length > 0 && <Watch rows={rows} />}
    </div>
  );
}
