import { expect, test } from "vitest";
import { VersionLineage } from "./version_lineage";

const content = (n: number, world: object | null = null) => ({ workspace: { n }, world });

test("a content that was seen is the version it was first kept as", () => {
  const lineage = new VersionLineage();
  lineage.add(content(1), "a");
  lineage.add(content(2), "b");
  lineage.add(content(1), "c");
  expect(lineage.of(content(1))).toBe("a");
});

test("what is new was made of what was here last, whatever was kept elsewhere", () => {
  const lineage = new VersionLineage();
  expect(lineage.of(content(1))).toBeUndefined();
  lineage.add(content(1), "a");
  expect(lineage.of(content(2))).toBe("a");
  lineage.add(content(3), "b");
  lineage.add(content(1), "c");
  expect(lineage.of(content(4))).toBe("c");
});

test("the same blocks in another world are another version", () => {
  const lineage = new VersionLineage();
  lineage.add(content(1), "a");
  lineage.add(content(1, { name: "own" }), "b");
  expect(lineage.of(content(1, { name: "other" }))).toBe("b");
  expect(lineage.of(content(1))).toBe("a");
});

test("contents seen long ago are forgotten", () => {
  const lineage = new VersionLineage();
  for (let n = 0; n < 100; n += 1) lineage.add(content(n), `v${n}`);
  expect(lineage.of(content(0))).toBe("v99");
  expect(lineage.of(content(50))).toBe("v50");
});
