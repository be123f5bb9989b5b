import { expect, test } from "vitest";
import type { Bundle, BundlePath } from "../bundle/bundle";
import { BundleModel } from "./bundle_model";
import { readSolidColours } from "./materials";

const path = (id: number, well = true): BundlePath => ({
  id,
  well,
  path: [
    [0, 0],
    [1, id / 10],
  ],
});

const bundle = (...paths: BundlePath[]): Bundle => ({ paths, isFaint: false });

/** Numbers of corners of all lines, and the farthest point. */
function drawn({ group }: BundleModel) {
  const meshes = group.children as unknown as BundleModel["well"]["mesh"][];
  const counts = meshes.map(({ geometry }) => geometry.drawRange.count);
  const reaches = meshes.map(({ geometry }, index) => {
    const positions = geometry.getAttribute("position");
    return Math.max(...Array.from({ length: counts[index] ?? 0 }, (_, at) => positions.getY(at)));
  });
  return { counts, top: Math.max(...reaches) };
}

const shown = (...bundles: (Bundle | null)[]) => {
  const model = new BundleModel(readSolidColours());
  for (const one of bundles) model.show(one);
  return model;
};

test("robots that arrive one after the other are drawn as all at once", () => {
  const [one, two, three] = [path(1), path(2, false), path(3)];
  const grown = shown(bundle(one), bundle(one, two), bundle(one, two, three));
  expect(drawn(grown)).toEqual(drawn(shown(bundle(one, two, three))));
  expect(drawn(grown).top).toBeGreaterThan(0.3);
});

test("a robot that did well ends in a dot, another in a cross", () => {
  const [well, badly, dotRims, crossRims, dots, crosses] = drawn(shown(bundle(path(1)))).counts;
  expect([well, dotRims, dots].every((count) => count)).toBe(true);
  expect([badly, crossRims, crosses]).toEqual([0, 0, 0]);
  expect(drawn(shown(bundle(path(1, false)))).counts.map(Boolean)).toEqual([
    false,
    true,
    false,
    true,
    false,
    true,
  ]);
});

test("other robots replace those before, and none leave nothing", () => {
  const model = shown(bundle(path(5), path(4)), bundle(path(1)));
  expect(drawn(model)).toEqual(drawn(shown(bundle(path(1)))));
  model.show(null);
  expect(drawn(model).counts).toEqual([0, 0, 0, 0, 0, 0]);
});
