import { describe, expect, test } from "vitest";
import furnished from "../../../../sim/worlds/furnished_room.json";
import neighbourhood from "../../../../sim/worlds/neighbourhood.json";
import type { World } from "../../api/model";
import { setLanguage } from "../../i18n";
import { areaOf } from "../areas";
import { hasPlateBelow, inkOn, isPictured, plateOf, platesOf } from "./places";

const TOWN = { title: "", ...neighbourhood } as unknown as World;
const zone = (name: string) => {
  const found = TOWN.zones.find((one) => one.name === name);
  if (!found) throw new Error(name);
  return found;
};
const [WIDTH, DEPTH] = [0.7, 0.28];

describe("the name of a place", () => {
  test.each(TOWN.zones.map(({ name }) => name))("%s lies beside all fields and streets", (name) => {
    const plate = plateOf(TOWN, zone(name), WIDTH, DEPTH);
    const streets = (TOWN.prints ?? []).filter(({ kind }) => kind === "street");
    for (const area of [...TOWN.zones, ...streets].map(areaOf)) {
      const [dx, dy] = [Math.abs(plate.x - area.x), Math.abs(plate.y - area.y)];
      expect(dx < (WIDTH + area.width) / 2 - 1e-9 && dy < (DEPTH + area.depth) / 2 - 1e-9).toBe(
        false,
      );
    }
  });

  test("tells a robot on the field on which side its own name is free", () => {
    const at = (name: string) => {
      const { x, y } = areaOf(zone(name));
      return hasPlateBelow(TOWN, { x, y });
    };
    expect(["casa", "padaria", "escola", "biblioteca"].map(at)).toEqual([true, true, false, false]);
    expect(hasPlateBelow(TOWN, { x: -100, y: 0 })).toBe(false);
  });

  test("is in the room where the field lies at the wall", () => {
    const last = { name: "meta", center: [3.6, -2.6], size: [0.8, 0.8], heading_deg: 0 } as const;
    const plate = plateOf({ ...TOWN, zones: [] }, last as never, WIDTH, DEPTH);
    expect(plate.x + WIDTH / 2).toBeLessThanOrEqual(4);
    expect(plate.y - DEPTH / 2).toBeGreaterThanOrEqual(-3);
  });
});

describe("a place has a pictogram", () => {
  test("in a world with a print, by its name", () => {
    expect(isPictured(TOWN, zone("padaria"))).toBe(true);
    expect(isPictured(TOWN, { ...zone("padaria"), name: "A" })).toBe(false);
    expect(isPictured({ ...TOWN, ground: null }, zone("padaria"))).toBe(false);
  });

  test("that stands out on its field", () => {
    expect(inkOn(TOWN, zone("escola"))).toBe("#ffffff");
    expect(inkOn(TOWN, zone("casa"))).not.toBe("#ffffff");
    expect(inkOn({ ...TOWN, floor: [] }, zone("casa"))).toBeNull();
    const wide = { color: "black", center: [-2, -2], size: [3, 1], heading_deg: 0 } as const;
    expect(inkOn({ ...TOWN, floor: [wide] } as never, zone("casa"))).toBe("#ffffff");
  });
});

test("all names of the town are shown on a floor of usual size; on a tiny one none lies on another", () => {
  const pictured = TOWN.zones.filter((zone) => isPictured(TOWN, zone));
  const shownAt = (letters: number) =>
    platesOf(TOWN, (text) => 0.7 * text.length * letters, 1.4 * letters).map(({ plate }) => plate);
  expect(shownAt(0.2)).toHaveLength(pictured.length);
  const tiny = shownAt(1.2);
  expect(tiny.length).toBeGreaterThan(0);
  expect(tiny.length).toBeLessThan(pictured.length);
  for (const [index, one] of tiny.entries()) {
    for (const other of tiny.slice(index + 1)) {
      const [dx, dy] = [Math.abs(one.x - other.x), Math.abs(one.y - other.y)];
      expect(dx >= (one.width + other.width) / 2 || dy >= one.depth).toBe(true);
    }
  }
});

test("a long name goes to another side of its field rather than be left out", () => {
  const room = { title: "", ...furnished } as unknown as World;
  const long = platesOf(room, (text) => 0.12 * `${text} · living room`.length, 0.28);
  expect(long.map(({ zone }) => zone.name)).toEqual(room.zones.map(({ name }) => name));
});

test("on a small floor a name goes without its translation", async () => {
  await setLanguage("en");
  const shownAt = (letters: number) =>
    platesOf(TOWN, (text) => (0.5 * text.length + 0.9) * letters, 1.4 * letters).map(
      ({ text }) => text,
    );
  expect(shownAt(0.2)).toContain("padaria · bakery");
  expect(shownAt(0.5)).toContain("padaria");
  await setLanguage("pt-BR");
});
