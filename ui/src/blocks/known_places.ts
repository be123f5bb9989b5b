let known: readonly string[] | null = null;

/** Sets the names of the world's places; null while the world is not known: then nothing is warned of. */
export function setKnownPlaces(names: readonly string[] | null): void {
  known = names;
}

export function knownPlaces(): readonly string[] | null {
  return known;
}
