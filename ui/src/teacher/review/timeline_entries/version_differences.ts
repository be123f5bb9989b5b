import { type Signal, signal } from "@preact/signals";
import type { TimelineEntry, VersionDifference } from "../../../api/model";
import { reviewApi } from "../../../api/review";
import { report } from "../../../kit/report";

const cache = new Map<string, Signal<VersionDifference | null>>();

/** Changes up to a timeline event; null without changes and before the response. */
export function differenceOf(entry: TimelineEntry | null): VersionDifference | null {
  return entry?.since && entry.version_id ? between(entry.since, entry.version_id).value : null;
}

/** The difference between two versions, cached, because versions never change. */
function between(from: string, to: string): Signal<VersionDifference | null> {
  const key = `${from}/${to}`;
  const known = cache.get(key);
  if (known) return known;
  const found = signal<VersionDifference | null>(null);
  cache.set(key, found);
  reviewApi.difference(from, to).then(
    (difference) => {
      found.value = difference;
    },
    (error) => {
      cache.delete(key);
      report(error);
    },
  );
  return found;
}
