import type { Mesh } from "three";
import { expect, test } from "vitest";
import type { Point } from "../../run/trail";
import type { Colours } from "../colours";
import { Trails } from "./trails";

const colours = new Proxy({}, { get: () => "#336699" }) as Colours;

/** Where the trails cover the line y = 0, in steps of 0.05 m: "#" and ".". */
function cover(trails: Trails, lengthM: number): string {
  const spans = (trails.group.children as Mesh[]).flatMap(({ geometry }) => {
    const { array } = geometry.getAttribute("position");
    // a dash on a straight line is a rectangle, and six of its 18 corners tell its ends
    return Array.from({ length: geometry.drawRange.count / 18 }, (_, dash) => {
      const xs = Array.from({ length: 6 }, (_, corner) => array[(dash * 18 + corner) * 3] ?? 0);
      return [Math.min(...xs), Math.max(...xs)] as const;
    });
  });
  return Array.from({ length: Math.round(lengthM / 0.05) }, (_, step) => {
    const middle = 0.05 * step + 0.025;
    return spans.some(([from, to]) => from < middle && middle < to) ? "#" : ".";
  }).join("");
}

const path = (...xs: number[]): Point[] => xs.map((x) => [x, 0]);

function drawnTrails(): Trails {
  const trails = new Trails(colours, { isDashed: true });
  for (const { geometry } of trails.group.children as Mesh[]) geometry.setDrawRange(0, 0);
  return trails;
}

test("a measured path is dotted, and nothing joins its pieces", () => {
  const trails = drawnTrails();
  trails.showMeasured([path(0, 0.3), path(0.6, 0.75, 0.9)]);
  expect(cover(trails, 0.9)).toBe("#.#.#.......#.#.#.");
});

test("another measured path replaces the first one, and none leaves nothing", () => {
  const trails = drawnTrails();
  trails.showMeasured([path(0, 0.3)]);
  trails.showMeasured([path(0.3, 0.5)]);
  expect(cover(trails, 0.6)).toBe("......#.#...");
  trails.showMeasured(undefined);
  expect(cover(trails, 0.6)).toBe("............");
});
