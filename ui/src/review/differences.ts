import { type Signal, signal } from "@preact/signals";
import { reviewApi } from "../api/review";
import { report } from "../app/session";
import type { VersionDifference } from "./model";

const known = new Map<string, Signal<VersionDifference | null>>();

/** What differs between two versions: null until the server has said it. Versions never change, so it is asked once. */
export function differenceOf(from: string, to: string): Signal<VersionDifference | null> {
  const key = `${from}/${to}`;
  const found = known.get(key) ?? signal<VersionDifference | null>(null);
  if (!known.has(key)) {
    known.set(key, found);
    reviewApi.difference(from, to).then(
      (difference) => {
        found.value = difference;
      },
      (error) => {
        known.delete(key);
        report(error);
      },
    );
  }
  return found;
}
