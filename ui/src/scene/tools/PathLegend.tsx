import type { ReadonlySignal } from "@preact/signals";
import { texts } from "../../i18n";
import type { RunView } from "../../run/reducer";
import { lastPoint } from "../../run/trail";

/** Says what the dashed line on the floor is, while there is one. */
export function PathLegend({ view }: { view: ReadonlySignal<RunView> }) {
  if (!lastPoint(view.value.idealPath)) return null;
  const { scene } = texts.value;
  return (
    <p class="scene__legend row middle gap-2" title={scene.desiredHelp} data-testid="path-legend">
      <svg viewBox="0 0 28 4" aria-hidden="true">
        <path d="M0 2h28" />
      </svg>
      {scene.desired}
    </p>
  );
}
