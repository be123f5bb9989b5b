import { type Difference, SIGNS } from "../editor/reader/difference_sign";

/** The sign of a difference, as on blocks, for lists. */
export function Sign({ kind }: { kind: Difference }) {
  return (
    <svg
      class={`difference-sign pinelSign--${kind} pinelSign`}
      viewBox="-13 -13 26 26"
      aria-hidden="true"
    >
      <circle r="12" />
      <path d={SIGNS[kind]} />
    </svg>
  );
}
