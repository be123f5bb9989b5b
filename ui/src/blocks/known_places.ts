let known: readonly string[] | null = null;

/**
 * Sets the names of the world's places. Null: the world is not loaded yet, and blocks show no
 * warning.
 */
export function setKnownPlaces(names: readonly string[] | null): void {
  known = names;
}

export function knownPlaces(): readonly string[] | null {
  return known;
}
