import { expect, test } from "vitest";
import type { Setup, World } from "../api/model";
import { textsOf } from "../i18n";
import { worlds } from "../shell/session";
import { setupOf } from "../studio/program/setup";
import { setupChanges } from "./setup_texts";

const PT = textsOf("pt-BR");
const AT_FIRST = setupOf(null);
const changes = (before: Setup | null, after: Setup | null) =>
  setupChanges(before, after, PT, "pt-BR");

worlds.value = [
  { name: "empty_room", title: { "pt-BR": "Sala vazia" } },
  { name: "maze", title: { "pt-BR": "Labirinto" } },
] as unknown as World[];

test("another world, robot, speed and start are named with what was before", () => {
  const after: Setup = {
    ...AT_FIRST,
    world: "maze",
    start: { x_m: 0.5, y_m: -1, heading_deg: 90 },
    preset: "realistic",
    speed: 0.5,
  };
  expect(changes(AT_FIRST, after)).toEqual([
    { what: "Mundo", before: "Sala vazia", after: "Labirinto" },
    { what: "Partida", before: "a do mundo", after: "x 0,50 m, y −1,00 m, 90°" },
    { what: "Robô", before: "Robô ideal", after: "Realista, com câmera" },
    { what: "Velocidade", before: "1×", after: "0,50×" },
  ]);
});

test("nothing is said of equal setups, nor of versions of an earlier release", () => {
  expect(changes(AT_FIRST, { ...AT_FIRST })).toEqual([]);
  expect(changes(null, AT_FIRST)).toEqual([]);
});
