import { type ReadonlySignal, useComputed } from "@preact/signals";
import { texts } from "../../i18n";
import type { RunView } from "../reducer";
import { Dialogue } from "./Dialogue";
import { Watch } from "./Watch";

interface RunOutputProps {
  view: ReadonlySignal<RunView>;
  /** More rows to watch: sensor values while the run is paused. */
  more?: ReadonlySignal<readonly (readonly [string, unknown])[]>;
}

/** Panel under the floor with the dialogue and the variables. Renders nothing without either. */
export function RunOutput({ view, more }: RunOutputProps) {
  const talk = useComputed(() => view.value.output.talk);
  const variables = useComputed(() => view.value.output.variables);
  const calls = useComputed(() => view.value.output.calls.map((call) => call.function).join(" › "));
  const paused = useComputed(() => view.value.phase === "paused");
  const gesture = useComputed(() => view.value.gesture);
  const number = useComputed(() => view.value.number);
  const { debug } = texts.value;
  const rows: (readonly [string, unknown])[] = Object.entries(variables.value);
  if (paused.value) {
    if (calls.value) rows.unshift([debug.calls, calls.value]);
    if (gesture.value !== null) rows.push([debug.gesture, gesture.value]);
    if (number.value !== null) rows.push([debug.number, number.value]);
    rows.push(...(more?.value ?? []));
  }
  if (talk.value.length === 0 && rows.length === 0) return null;
  return (
    <div class="shown row rigid gap-2">
      {talk.value.length > 0 && <Dialogue lines={talk.value} />}
      {rows.length > 0 && <Watch rows={rows} />}
    </div>
  );
}
