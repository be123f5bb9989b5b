import { file, get, post, put } from "./client";

/** Type of the files to choose from, as the end of their names. */
export type DriveFileSuffix = ".pinel" | ".json" | ".onnx";

/** Requests about kiosk mode, and for the files that replace its file dialogs. */
export const kioskApi = {
  state: () => get("/api/kiosk"),
  /** A window that is in the other mode closes, and opens again. */
  choose: (isChosen: boolean) => put("/api/kiosk", { body: { is_chosen: isChosen } }),
  leave: () => post("/api/kiosk/leave", {}),
  /** Lets the page open the print dialog once. */
  allowPrint: () => post("/api/kiosk/print", {}),

  drives: async (suffix: DriveFileSuffix) =>
    (await get("/api/drives", { params: { query: { suffix } } })).drives,
  driveFile: (path: string, suffix: DriveFileSuffix) =>
    file(get("/api/drives/file", { params: { query: { path, suffix } }, parseAs: "blob" })),
  /** If the name is taken, the file gets a number. */
  saveOnDrive: (drive: string, name: string, content: Blob) =>
    post("/api/drives/file", {
      params: { query: { drive, name } },
      headers: { "Content-Type": "application/octet-stream" },
      body: content as unknown as string, // the server's description types octets as text
      bodySerializer: (octets) => octets,
    }),
};
