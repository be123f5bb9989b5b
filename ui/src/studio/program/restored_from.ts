import { signal } from "@preact/signals";
import type { VersionSummary } from "../../api/model";

/** A restored version, and the version that it replaced. */
export interface RestoredFrom {
  program: string;
  from: VersionSummary;
  instead: VersionSummary;
}

/** The last restore, until its program is closed. */
export const restoredFrom = signal<RestoredFrom | null>(null);
