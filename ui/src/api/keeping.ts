import { json } from "./client";
import type { Content, Program, SavedVersion } from "./model";
import type { components } from "./types";

type Schemas = components["schemas"];

/** A version in the line of its program, without its blocks. */
export type VersionMark = Schemas["VersionMark"];
export type StoredVersion = Schemas["VersionOfProgram"];
export type VersionDifference = Schemas["VersionDifference"];
export type Note = Schemas["Note"];

const PAGE = 200;

type Notes = { notes: Note[] };

/** What is never lost: versions, the bin, notes of the teacher. */
export const keeping = {
  /** All versions of a program, the oldest first. */
  line: async (program: string): Promise<VersionMark[]> => {
    const newestFirst: VersionMark[] = [];
    let before = "";
    do {
      const page = await json<Schemas["VersionLine"]>(
        "GET",
        `/api/programs/${program}/versions?limit=${PAGE}${before && `&before=${before}`}`,
      );
      newestFirst.push(...page.versions);
      before = page.next ?? "";
    } while (before);
    return newestFirst.reverse();
  },
  /** The version that stands before another in the line, whatever either was made of. */
  before: async (program: string, version: string): Promise<string | null> =>
    (
      await json<Schemas["VersionLine"]>(
        "GET",
        `/api/programs/${program}/versions?limit=1&before=${version}`,
      )
    ).versions[0]?.id ?? null,
  version: (id: string) => json<StoredVersion>("GET", `/api/versions/${id}`),
  difference: (from: string, to: string) =>
    json<VersionDifference>("GET", `/api/versions/${from}/difference?to=${to}`),
  /** Gives a version a name; "" takes it away. */
  label: (id: string, text: string) => json<object>("PUT", `/api/versions/${id}/label`, { text }),
  /** Keeps an old content once more, as the newest version. */
  goOnFrom: (program: string, parent: string, content: Content) =>
    json<SavedVersion>("POST", `/api/programs/${program}/versions`, {
      ...content,
      parent_id: parent,
    }),

  bin: async (group: string) =>
    (await json<{ programs: Program[] }>("GET", `/api/groups/${group}/bin`)).programs,
  throwAway: (program: string) => json<Program>("DELETE", `/api/programs/${program}`),
  takeBack: (program: string) => json<Program>("POST", `/api/programs/${program}/take-back`),

  unseenNotes: async (group: string) =>
    (await json<Notes>("GET", `/api/groups/${group}/notes?unseen=true`)).notes,
  notesOfRun: async (run: string) => (await json<Notes>("GET", `/api/runs/${run}/notes`)).notes,
  seeNote: (note: string) => json<Note>("POST", `/api/notes/${note}/seen`),
};
