import { signal } from "@preact/signals";
import type { VersionMark } from "../api/keeping";

/** An older version that a group went on from, and the one whose place it took. */
export interface WentOn {
  program: string;
  from: VersionMark;
  instead: VersionMark;
}

/** The last such step, until its program is left. */
export const wentOn = signal<WentOn | null>(null);
