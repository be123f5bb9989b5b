import { signal } from "@preact/signals";
import type { VersionMark } from "../../api/model";

/** An older version that a group went on from, and the one whose place it took. */
export interface RestoredFrom {
  program: string;
  from: VersionMark;
  instead: VersionMark;
}

/** The last such step, until its program is left. */
export const restoredFrom = signal<RestoredFrom | null>(null);
