import { BADGE_PATHS, type Difference } from "../editor/reader/difference_badge";

/** The badge of a difference, as on blocks, for lists. */
export function DifferenceIcon({ kind }: { kind: Difference }) {
  return (
    <svg
      class={`difference-sign pinelSign--${kind} pinelSign`}
      viewBox="-13 -13 26 26"
      aria-hidden="true"
    >
      <circle r="12" />
      <path d={BADGE_PATHS[kind]} />
    </svg>
  );
}
