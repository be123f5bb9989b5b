import { expect, test } from "vitest";
import { SCREENS } from "../shell/route";
import { LOADS, PARTS } from "./screens";

test("each screen of the table has a component, and none stands beside it", () => {
  expect(Object.keys(PARTS).sort()).toEqual([...SCREENS].sort());
});

test("the file of a screen exports its component", async () => {
  const loaded = await Promise.all(
    Object.values(LOADS).map(async (load) => (await load?.())?.name),
  );
  expect(loaded.map((name) => name?.replace("Screen", "").toLowerCase())).toEqual(
    Object.keys(LOADS),
  );
}, 30_000);
