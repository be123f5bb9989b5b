import { expect, test } from "vitest";
import neighbourhood from "../../../sim/worlds/neighbourhood.json";
import type { World } from "../api/model";
import { textsOf } from "../i18n";
import { aheadOf } from "./ahead";
import { describeFloor } from "./solid/description";

const box = (kind: string | null, x: number, y: number, movable = false) => ({
  kind,
  center: [x, y],
  size: [0.4, 0.4],
  heading_deg: 0,
  movable,
});
const ROOM = {
  ...neighbourhood,
  title: "",
  zones: [{ name: "padaria", center: [0, 0], size: [1, 1], heading_deg: 0 }],
  start: { x_m: 0, y_m: 0, heading_deg: 0 },
  boxes: [box("crate", 2, 0), box(null, 0, 2, true)],
} as unknown as World;

test("what is ahead is the nearest body on the robot's line", () => {
  expect(aheadOf(ROOM, {}, { x: 0, y: 0, yaw: 0 })).toEqual({ metres: 1.8, box: ROOM.boxes[0] });
  expect(aheadOf(ROOM, {}, { x: 0, y: 0, yaw: Math.PI / 2 })?.box).toBe(ROOM.boxes[1]);
  const behind = aheadOf(ROOM, {}, { x: 0, y: 0, yaw: Math.PI });
  expect(behind?.box).toBeNull();
  expect(behind?.metres).toBeCloseTo(3.955);
});

test("a pushed box is where it was pushed to", () => {
  const poses = { 1: [0, 2.5, 0] };
  expect(aheadOf(ROOM, poses, { x: 0, y: 0, yaw: Math.PI / 2 })?.metres).toBeCloseTo(2.3);
  expect(aheadOf(ROOM, { 1: [1, 2.5, 0] }, { x: 0, y: 0, yaw: Math.PI / 2 })?.box).toBeNull();
});

test("the picture in words says where the robot is and what it faces", () => {
  const say = (yaw: number) =>
    describeFloor(
      { world: ROOM, boxes: {}, truth: { x: 0, y: 0, yaw }, radius: 0.2 },
      textsOf("pt-BR"),
      "pt-BR",
    );
  expect(say(0)).toBe(
    "Chão em 3D. Robô em x 0,00 m, y 0,00 m, virado para 0°. Ele está em: padaria. À frente, a 1,60 m: caixote.",
  );
  expect(say(Math.PI / 2)).toContain("a 1,60 m: caixa.");
  expect(say(Math.PI)).toContain("a 3,76 m: parede.");
});
