import type { RunOutcome } from "./model";

/** Icons by outcome: shape and symbol carry the meaning, colour only repeats it. */
const ICONS: Record<RunOutcome, preact.JSX.Element> = {
  passed: (
    <>
      <circle class="sign__full" cx="12" cy="12" r="11" />
      <path
        class="sign__on-full"
        d="m12 4.800 2.200 4.700 5.100.6-3.800 3.500 1 5.100L12 16.100l-4.500 2.600 1-5.100L4.700 10.100l5.100-.6z"
      />
    </>
  ),
  finished: (
    <>
      <circle class="sign__line" cx="12" cy="12" r="9.500" />
      <circle class="sign__full" cx="12" cy="12" r="4.200" />
    </>
  ),
  notyet: (
    <>
      <circle class="sign__line" cx="12" cy="12" r="9.500" />
      <path class="sign__stroke" d="M7.500 12h9" />
    </>
  ),
  stopped: (
    <>
      <rect class="sign__line" x="3" y="3" width="18" height="18" rx="4" />
      <rect class="sign__full" x="8" y="8" width="8" height="8" rx="1" />
    </>
  ),
  failed: (
    <>
      <path class="sign__full" d="M12 .6 23.400 12 12 23.400.6 12z" />
      <path class="sign__on-full-stroke" d="M12 6.500v6.500M12 16.500v.4" />
    </>
  ),
  running: (
    <>
      <circle class="sign__line sign__line--dotted" cx="12" cy="12" r="9.500" />
      <path class="sign__full" d="m9.500 7.500 7 4.500-7 4.500z" />
    </>
  ),
};

interface OutcomeIconProps {
  outcome: RunOutcome;
}

/** Icon of a run's outcome. */
export function OutcomeIcon({ outcome }: OutcomeIconProps) {
  return (
    <svg class={`sign sign--${outcome}`} viewBox="0 0 24 24" aria-hidden="true">
      {ICONS[outcome]}
    </svg>
  );
}
