import { expect, test } from "vitest";
import { Parents } from "./parents";

const content = (n: number, world: object | null = null) => ({ workspace: { n }, world });

test("a content that was seen is the version it was first kept as", () => {
  const parents = new Parents();
  parents.keep(content(1), "a");
  parents.keep(content(2), "b");
  parents.keep(content(1), "c");
  expect(parents.of(content(1))).toBe("a");
});

test("what is new was made of what was here last, whatever was kept elsewhere", () => {
  const parents = new Parents();
  expect(parents.of(content(1))).toBeUndefined();
  parents.keep(content(1), "a");
  expect(parents.of(content(2))).toBe("a");
  parents.keep(content(3), "b");
  parents.keep(content(1), "c");
  expect(parents.of(content(4))).toBe("c");
});

test("the same blocks in another world are another version", () => {
  const parents = new Parents();
  parents.keep(content(1), "a");
  parents.keep(content(1, { name: "own" }), "b");
  expect(parents.of(content(1, { name: "other" }))).toBe("b");
  expect(parents.of(content(1))).toBe("a");
});

test("contents seen long ago are forgotten", () => {
  const parents = new Parents();
  for (let n = 0; n < 100; n += 1) parents.keep(content(n), `v${n}`);
  expect(parents.of(content(0))).toBe("v99");
  expect(parents.of(content(50))).toBe("v50");
});
