import { asFile, del, fileAnswer, get, of, post, put } from "./client";
import type { Notice } from "./model";

/** Requests that carry work from PC to PC: bundles, the shared folder, program files. */
export const exchange = {
  folders: () => get("/api/folders"),
  /** Stores the path of the school's shared folder; "" stands for no folder. */
  share: (path: string) => put("/api/folders/shared", { body: { path } }),
  /** Sets whether copies of this PC's backups go to the shared folder. */
  shareBackups: (path: string, withBackups: boolean) =>
    put("/api/folders/shared", { body: { path, takes_backups: withBackups } }),
  write: (folder: string, classroom_id: string | null, anonymous: boolean) =>
    post("/api/bundles", { body: { folder, classroom_id, anonymous } }),
  /**
   * Without `retained`, deletes nothing. With it, also deletes here what the other PC deleted for
   * good, except the groups and programs in `retained`.
   */
  merge: async (path: string, retained?: readonly string[]) => {
    const drop = retained !== undefined;
    const body = { paths: [path], delete: drop, kept: [...(retained ?? [])], keep_newer: false };
    return (await post("/api/bundles/merge", { body })).merged[0];
  },
  knownComputers: () => get("/api/bundles/heard"),

  deleteGroup: (id: string) => del("/api/groups/{id}", of(id)),
  deleteClassroom: (id: string) => del("/api/classrooms/{id}", of(id)),

  /** The file, and the server's notice about missing parts; null if the program is complete. */
  programFile: async (program: string) =>
    workFile(await fileAnswer("/api/programs/{id}/file", asFile(program))),
  /** The same of all work of a group. */
  groupFile: async (group: string) =>
    workFile(await fileAnswer("/api/groups/{id}/file", asFile(group))),
  /** An error names the file by its name in the folder where the user chose it. */
  bringProgram: (bundle: File) =>
    post("/api/programs/file", {
      params: { query: { name: bundle.name } },
      headers: { "Content-Type": "application/octet-stream" },
      body: bundle as unknown as string, // the server's description types octets as text
      bodySerializer: (octets) => octets,
    }),
};

function workFile({ data, response }: { data: Blob; response: Response }) {
  const header = response.headers.get("Pinel-Left-Out");
  return { octets: data, leftOut: header ? (JSON.parse(header) as Notice) : null };
}
