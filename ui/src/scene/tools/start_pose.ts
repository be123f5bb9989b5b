import type { Start, World } from "../../api/model";
import { HANDLE_M, roomOf, type XY } from "../frames";
import { onGrid, onTurn, turned } from "./measure";

/** Minimum distance of the start from the outer walls, metres. */
const CLEAR_M = 0.3;

/** Moves a start to a point inside the outer walls, snapped to 0.1 m unless `free`. */
export function movedTo(start: Start, place: XY, world: World | null, free: boolean): Start {
  const room = roomOf(world);
  const clear = (value: number, low: number, high: number) => {
    const inside = Math.min(high - CLEAR_M, Math.max(low + CLEAR_M, value));
    return round(free ? inside : onGrid(inside), 4);
  };
  return {
    ...start,
    x_m: clear(place.x, room.left, room.right),
    y_m: clear(place.y, room.bottom, room.top),
  };
}

/** Turns a start towards a point, in steps of 15 degrees unless `free`. */
export function facing(start: Start, place: XY, free: boolean): Start {
  const heading = (Math.atan2(place.y - start.y_m, place.x - start.x_m) * 180) / Math.PI;
  return { ...start, heading_deg: round(turned(free ? heading : onTurn(heading)), 1) };
}

/** Moves or turns a start by one key press: metres, or degrees to the left. */
export function nudged(start: Start, key: string, world: World | null, fine: boolean): Start {
  const step = fine ? 0.01 : 0.1;
  const direction = KEYS[key];
  if (direction) {
    const place = { x: start.x_m + direction[0] * step, y: start.y_m + direction[1] * step };
    return movedTo(start, place, world, fine);
  }
  const turn = { ",": 1, ".": -1, "<": 1, ">": -1 }[key] ?? 0;
  return { ...start, heading_deg: round(turned(start.heading_deg + turn * (fine ? 1 : 15)), 1) };
}

const KEYS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

export const isStartKey = (key: string) => key in KEYS || [",", ".", "<", ">"].includes(key);

/** Direction of an arrow key. */
export const directionOf = (key: string) => KEYS[key];

const round = (value: number, digits: number) => {
  const rounded = Math.round(value * 10 ** digits) / 10 ** digits;
  return rounded === 0 ? 0 : rounded;
};

export const handleOf = ({ x_m, y_m, heading_deg }: Start): XY => {
  const yaw = (heading_deg * Math.PI) / 180;
  return { x: x_m + HANDLE_M * Math.cos(yaw), y: y_m + HANDLE_M * Math.sin(yaw) };
};
