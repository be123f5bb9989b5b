interface MissingLetter {
  readonly letter: string;
  /** Whether the sign includes a movement. */
  readonly moves: boolean;
  /**
   * Path of the hand in a mirror, as SVG path data in a box of 24 by 24; "" if the hand is at rest.
   */
  readonly path: string;
}

/** The letters that the camera recognises only after teaching. */
export const MISSING_LETTERS: readonly MissingLetter[] = [
  { letter: "Ç", moves: true, path: "M3 12q2.25-6 4.5 0t4.5 0 4.5 0 4.5 0" }, // a C that trembles
  { letter: "H", moves: true, path: "M5 15a7 5 0 1 1 14 0M19 15l-3-2M19 15l2-3" },
  { letter: "J", moves: true, path: "M15 4v10a5 5 0 0 1-9 2M6 16l-1 4M6 16l4 1" },
  { letter: "X", moves: true, path: "M4 10L19 15M19 15l-4 1M19 15l-2-4" },
  { letter: "Y", moves: false, path: "" },
  { letter: "Z", moves: true, path: "M5 6h13L6 18h13M19 18l-4-3M19 18l-4 3" },
];

/** A letter with the path of the hand that signs it. */
export function MovementDrawing({ letter }: { letter: string }) {
  const path = MISSING_LETTERS.find((one) => one.letter === letter)?.path;
  return (
    <>
      {letter}
      {path && (
        <svg class="teaching__way" viewBox="0 0 24 24" aria-hidden="true">
          <path d={path} />
        </svg>
      )}
    </>
  );
}
