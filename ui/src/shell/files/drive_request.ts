import { signal } from "@preact/signals";
import type { DriveFileSuffix } from "../../api/kiosk";

interface Opening {
  kind: "open";
  suffix: DriveFileSuffix;
  /** May return a promise; its failure is reported. */
  onFile(file: File): unknown;
}

interface Saving {
  kind: "save";
  name: string;
  content: Blob;
}

/** What `DriveDialog` asks the person for: a file to open, or where to save one; null without a dialog. */
export const driveRequest = signal<Opening | Saving | null>(null);
