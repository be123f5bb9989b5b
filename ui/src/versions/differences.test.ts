import { expect, test } from "vitest";
import { commentText, differing, hiddenChange, kindsOf } from "./differences";

const mark = (block: string) => ({ block, type: "move_forward" });
const change = { name: "DISTANCE", before: 1, after: 2 };
const difference = {
  added: [mark("new")],
  removed: [mark("old")],
  changed: [
    { ...mark("set"), what: [change] },
    { ...mark("both"), what: [change] },
  ],
  moved: [mark("both"), mark("away")],
};

test("a block that was changed and moved is told once", () => {
  expect(differing(difference).map(({ block, kinds }) => [block, ...kinds])).toEqual([
    ["old", "removed"],
    ["new", "added"],
    ["set", "changed"],
    ["both", "changed", "moved"],
    ["away", "moved"],
  ]);
});

test("on either side only the blocks that are there are marked", () => {
  const ids = (side: "before" | "after") => kindsOf(difference, side).map(([id]) => id);
  expect(ids("before")).toEqual(["old", "set", "both", "away"]);
  expect(ids("after")).toEqual(["new", "set", "both", "away"]);
});

test("a comment that changed is told, whatever it is kept as", () => {
  const comment = { name: "comment", before: null, after: { text: "oi", height: 80 } };
  expect(hiddenChange([change, comment])).toBe(comment);
  expect(hiddenChange([change])).toBeNull();
  expect(commentText(comment.after)).toBe("oi");
  expect(commentText("oi")).toBe("oi");
  expect(commentText(null)).toBe("");
});
