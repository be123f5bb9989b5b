import { MeshBasicMaterial } from "three";
import { expect, test } from "vitest";
import { EMPTY_TRAIL, extend, type Point, type Trail } from "../../run/trail";
import { Ribbon, TrailRibbon } from "./ribbon";

const ribbon = (dash?: readonly [number, number]) =>
  new Ribbon(new MeshBasicMaterial(), { width: 0.1, z: 0.003, ...(dash && { dash }) });

/** The parts of the floor that a ribbon covers, in cells of a centimetre. */
function covered({ mesh }: Ribbon): Set<string> {
  const positions = mesh.geometry.getAttribute("position");
  const cells = new Set<string>();
  for (let at = 0; at < mesh.geometry.drawRange.count; at++) {
    cells.add(`${positions.getX(at).toFixed(2)} ${positions.getY(at).toFixed(2)}`);
  }
  return cells;
}

const along = (n: number): Trail => {
  let trail = EMPTY_TRAIL;
  for (let at = 0; at < n; at++) trail = extend(trail, [0.02 * at, at > 150 ? 0.5 : 0] as Point);
  return trail;
};

test("a line that grew is the one that is drawn at once", () => {
  const [grown, whole] = [
    new TrailRibbon(ribbon(), "#ff0000"),
    new TrailRibbon(ribbon(), "#ff0000"),
  ];
  for (const n of [1, 40, 90, 91, 200, 400]) grown.show(along(n), null);
  whole.show(along(400), null);
  expect(covered(grown.ribbon)).toEqual(covered(whole.ribbon));
  expect(covered(whole.ribbon).size).toBeGreaterThan(400);
});

test("a replay that goes back shows the line of then", () => {
  const [seeking, fresh] = [
    new TrailRibbon(ribbon(), "#ff0000"),
    new TrailRibbon(ribbon(), "#ff0000"),
  ];
  seeking.show(along(400), null);
  seeking.show(along(80), [1.7, 0]);
  fresh.show(along(80), [1.7, 0]);
  expect(covered(seeking.ribbon)).toEqual(covered(fresh.ribbon));
});

test("a dashed line has gaps, at the same places however long its parts are", () => {
  const [short, long] = [ribbon([0.1, 0.1]), ribbon([0.1, 0.1])];
  short.append(
    Array.from({ length: 101 }, (_, at): Point => [0.01 * at, 0]),
    "#ff0000",
  );
  long.append(
    [
      [0, 0],
      [1, 0],
    ],
    "#ff0000",
  );
  for (const one of [short, long]) one.upload();
  const ends = [0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9].map((x) => `${x.toFixed(2)} 0.05`);
  expect([...covered(long)].filter((cell) => cell.endsWith(" 0.05")).sort()).toEqual(ends);
  for (const end of ends) expect(covered(short).has(end)).toBe(true);
});
