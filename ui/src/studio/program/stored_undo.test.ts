import { afterEach, expect, test, vi } from "vitest";
import type { VersionOfProgram } from "../../api/model";
import { versionsApi } from "../../api/versions";
import type { OpenProgram } from "./open_program";
import { StoredUndo } from "./stored_undo";

/** A program with these versions; the last is the newest. */
function program(versions: { id: string; parent: string | null; n: number }[]) {
  const stored = (id: string) => {
    const at = versions.findIndex((one) => one.id === id);
    const { n, parent } = versions[at] ?? { n: 0, parent: null };
    return {
      id,
      parent_id: parent,
      number: at + 1,
      workspace: { n },
    } as unknown as VersionOfProgram;
  };
  vi.spyOn(versionsApi, "version").mockImplementation(async (id) => stored(id));
  vi.spyOn(versionsApi, "before").mockImplementation(
    async (_, id) => versions[versions.findIndex((one) => one.id === id) - 1]?.id ?? null,
  );
  const storedVersions: string[] = [];
  const open = {
    id: "program",
    autosave: { flush: async () => ({ id: versions.at(-1)?.id }) },
    setStoredVersion: (id: string) => storedVersions.push(id),
  } as unknown as OpenProgram;
  return { undo: new StoredUndo(open), storedVersions };
}

afterEach(() => vi.restoreAllMocks());

test("undo goes on with the version that the newest was made of", async () => {
  const { undo, storedVersions } = program([
    { id: "a", parent: null, n: 1 },
    { id: "b", parent: "a", n: 2 },
    { id: "c", parent: "a", n: 3 },
  ]);
  const offered: unknown[] = [];
  await undo.back((workspace) => offered.push(workspace) > 0);
  expect(offered).toEqual([{ n: 1 }]);
  expect(storedVersions).toEqual(["a"]);
});

test("what looks the same is passed over, and before the first there was nothing", async () => {
  const { undo, storedVersions } = program([
    { id: "a", parent: null, n: 1 },
    { id: "b", parent: "a", n: 1 },
  ]);
  const offered: unknown[] = [];
  await undo.back((workspace) => offered.push(workspace) > 1);
  expect(offered).toEqual([{ n: 1 }, null]);
  expect(storedVersions).toEqual([]);
});

test("a version that does not tell its parent is followed by the one before in the line", async () => {
  const { undo, storedVersions } = program([
    { id: "a", parent: null, n: 1 },
    { id: "b", parent: null, n: 2 },
  ]);
  await undo.back(() => true);
  expect(storedVersions).toEqual(["a"]);
});
