import { asFile, del, fileAnswer, get, of, post, put } from "./client";
import type { Notice } from "./model";

/** Work from PC to PC. */
export const exchange = {
  folders: () => get("/api/folders"),
  /** Remembers the school's shared folder; "" for none. */
  share: (path: string) => put("/api/folders/shared", { body: { path } }),
  /** Whether copies of this PC's backups go there. */
  shareBackups: (path: string, withBackups: boolean) =>
    put("/api/folders/shared", { body: { path, takes_backups: withBackups } }),
  write: (folder: string, classroom_id: string | null, anonymous: boolean) =>
    post("/api/bundles", { body: { folder, classroom_id, anonymous } }),
  /** Without `kept` nothing is deleted; with it what was deleted for good on the other PC goes here too, but for these. */
  merge: async (path: string, retained?: readonly string[]) => {
    const drop = retained !== undefined;
    const body = { paths: [path], delete: drop, kept: [...(retained ?? [])], keep_newer: false };
    return (await post("/api/bundles/merge", { body })).merged[0];
  },
  knownComputers: () => get("/api/bundles/heard"),

  deleteGroup: (id: string) => del("/api/groups/{id}", of(id)),
  deleteClassroom: (id: string) => del("/api/classrooms/{id}", of(id)),

  /** With what the file lacks, as the server says it; null where it has all of the program. */
  programFile: async (program: string) => {
    const { data, response } = await fileAnswer("/api/programs/{id}/file", asFile(program));
    const header = response.headers.get("Pinel-Left-Out");
    return { octets: data, leftOut: header ? (JSON.parse(header) as Notice) : null };
  },
  /** An error names the file by the name it has where it was chosen. */
  bringProgram: (bundle: File) =>
    post("/api/programs/file", {
      params: { query: { name: bundle.name } },
      headers: { "Content-Type": "application/octet-stream" },
      body: bundle as unknown as string, // the description knows octets as text
      bodySerializer: (octets) => octets,
    }),
};
