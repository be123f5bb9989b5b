import { expect, it } from "vitest";
import type { RealRobot, RealRun } from "../../../api/model";
import { documentOf, driven, sideFor } from "./pattern";

const robot = (width: number, start: object = {}) =>
  ({
    world: { size_m: [width, 4], start: { x_m: 0, y_m: 0, heading_deg: 0, ...start } },
  }) as unknown as RealRobot;

it("chooses the longest side with which both squares fit in each room", () => {
  expect(sideFor([robot(8)])).toBe(1.6);
  expect(sideFor([robot(4, { heading_deg: 90 })])).toBe(1.6);
  expect(sideFor([robot(8), robot(2)])).toBe(0.6);
  expect(sideFor([robot(4, { x_m: 1.5 })])).toBeNull();
});

it("turns the squares to their side", () => {
  const turnOf = (shape: "left" | "right") => JSON.stringify(documentOf(shape, 1.2));
  expect(turnOf("left")).toContain('"angle":90');
  expect(turnOf("right")).toContain('"angle":-90');
});

it("counts the runs of one robot, apart those that nobody measured", () => {
  const run = (shape: RealRun["shape"], sources: RealRun["sources"], link = "dds") =>
    ({ shape, sources, link }) as RealRun;
  const runs = [run("left", ["tape"]), run("left", []), run("right", ["tape"])];
  runs.push(run("left", ["tape"], "bridge"));
  expect(driven(runs, "left")).toEqual({ measured: 1, unmeasured: 1 });
  expect(driven(runs, "line")).toEqual({ measured: 0, unmeasured: 0 });
});
