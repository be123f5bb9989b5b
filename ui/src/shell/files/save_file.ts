import { isKiosk } from "../kiosk";
import { driveRequest } from "./drive_request";

/** Saves a file: a browser puts it among the downloads, the window shows a save dialog, kiosk mode its drives. */
export function saveFile(name: string, content: Blob): void {
  if (isKiosk()) {
    driveRequest.value = { kind: "save", name, content };
    return;
  }
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  // the browser has started the download but may not have read the blob yet
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

/** A portable file name: "Sala do Zé" becomes "sala-do-ze". */
export function fileName(title: string, otherwise: string): string {
  const plain = title.normalize("NFD").replace(/\p{M}/gu, "").toLowerCase();
  return (
    plain
      .replace(/[^a-z0-9]+/g, "-")
      .replace(/^-|-$/g, "")
      .slice(0, 60) || otherwise
  );
}
