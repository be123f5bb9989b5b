import { expect, test } from "vitest";
import { Parents } from "./parents";

test("a content that was seen is the version it was first kept as", () => {
  const parents = new Parents();
  parents.keep({ n: 1 }, "a");
  parents.keep({ n: 2 }, "b");
  parents.keep({ n: 1 }, "c");
  expect(parents.of({ n: 1 })).toBe("a");
  expect(parents.of({ n: 3 })).toBeUndefined();
});

test("contents seen long ago are forgotten", () => {
  const parents = new Parents();
  for (let n = 0; n < 100; n += 1) parents.keep({ n }, `v${n}`);
  expect(parents.of({ n: 0 })).toBeUndefined();
  expect(parents.of({ n: 99 })).toBe("v99");
});
