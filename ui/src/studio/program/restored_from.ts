import { signal } from "@preact/signals";
import type { VersionMark } from "../../api/model";

/** A restored version, and the version that it replaced. */
export interface RestoredFrom {
  program: string;
  from: VersionMark;
  instead: VersionMark;
}

/** The last restore, until its program is closed. */
export const restoredFrom = signal<RestoredFrom | null>(null);
