import { api, del, get, of, post, put } from "./client";
import type { EditorContent, VersionLine, VersionSummary } from "./model";
import { reviewApi } from "./review";

const PAGE = 200;

function page(id: string, limit: number, before: string | null) {
  const query = { limit, before };
  return get("/api/programs/{id}/versions", { params: { path: { id }, query } });
}

/** Requests about work that is never lost: versions, the bin, notes of the teacher. */
export const versionsApi = {
  /** All versions of a program, the oldest first. */
  line: async (program: string): Promise<VersionSummary[]> => {
    const newestFirst: VersionSummary[] = [];
    let before: string | null = null;
    do {
      const { versions, next }: VersionLine = await page(program, PAGE, before);
      newestFirst.push(...versions);
      before = next;
    } while (before);
    return newestFirst.reverse();
  },
  /** The version with the next lower number, whichever version either was edited from. */
  before: async (program: string, version: string): Promise<string | null> =>
    (await page(program, 1, version)).versions[0]?.id ?? null,
  version: (id: string) => get("/api/versions/{id}", of(id)),
  difference: reviewApi.difference,
  /** Sets the name of a version; "" removes it. */
  label: (id: string, text: string) =>
    put("/api/versions/{id}/label", { ...of(id), body: { text } }),
  /** Stores the content of an old version again as the newest version. */
  saveAsNewest: (program: string, parent_id: string, content: EditorContent) =>
    api.saveVersion(program, { ...content, parent_id }),

  bin: async (group: string) => (await get("/api/groups/{id}/bin", of(group))).programs,
  throwAway: (program: string) => del("/api/programs/{id}", of(program)),
  restore: (program: string) => post("/api/programs/{id}/take-back", of(program)),

  unseenNotes: async (id: string) =>
    (await get("/api/groups/{id}/notes", { params: { path: { id }, query: { unseen: true } } }))
      .notes,
  notesOfRun: reviewApi.notes,
  acknowledgeNote: (note: string) => post("/api/notes/{id}/seen", of(note)),
};
