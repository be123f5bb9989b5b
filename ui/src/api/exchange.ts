import { json, octets, sendFile } from "./client";
import type { components } from "./types";

type Schemas = components["schemas"];

export type FoundFile = Schemas["FileFound"];
export type Folder = Schemas["Folder"];
export type Bundle = Schemas["Bundle"];
export type Merged = Schemas["Merged"];
export type Removed = Schemas["Removed"];
export type HeardComputer = Schemas["HeardComputer"];

export type Places = Schemas["FolderList"];

/** Work from PC to PC. */
export const exchange = {
  folders: () => json<Places>("GET", "/api/folders"),
  /** Remembers the school's shared folder; "" for none. */
  share: (path: string) => json<Places>("PUT", "/api/folders/shared", { path }),
  write: (folder: string, classroom: string | null, anonymous: boolean) =>
    json<Bundle>("POST", "/api/bundles", { folder, classroom_id: classroom, anonymous }),
  /** `drop`: what was deleted for good on the other PC goes here too. */
  merge: async (path: string, drop = false) =>
    (
      await json<{ merged: Merged[] }>("POST", "/api/bundles/merge", {
        paths: [path],
        delete: drop,
      })
    ).merged[0],
  heard: async () =>
    (await json<{ computers: HeardComputer[] }>("GET", "/api/bundles/heard")).computers,

  deleteGroup: (id: string) => json<Removed>("DELETE", `/api/groups/${id}`),
  deleteClassroom: (id: string) => json<Removed>("DELETE", `/api/classrooms/${id}`),

  programFile: (program: string) => octets(`/api/programs/${program}/file`),
  /** A refusal calls the file what it is called where it was chosen. */
  bringProgram: (file: File) =>
    sendFile<Schemas["BroughtProgram"]>(
      `/api/programs/file?name=${encodeURIComponent(file.name)}`,
      file,
    ),
};
