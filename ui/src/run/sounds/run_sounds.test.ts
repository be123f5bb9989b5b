import { expect, test } from "vitest";
import { textsOf } from "../../i18n";
import { IDLE, type RunView } from "../reducer";
import { sentenceOf } from "../sentence";
import { soundBetween } from "./run_sounds";

const at = (phase: RunView["phase"], more: Partial<RunView> = {}): RunView => ({
  ...IDLE,
  run: "r",
  phase,
  ...more,
});
const ending = {
  reason: null,
  params: {},
  block: null,
  durationS: 1,
  pathLengthM: 1,
  closingErrorM: 0,
  estimatedClosingErrorM: 0,
};
const blocked = {
  ...ending,
  reason: "blocked",
  params: { done: 0.4, amount: 1, unit: "m", action: "move_forward" },
};
const running = at("running");

/** Each sound, the states around it, and the words on the screen at the same moment: its visible equal. */
const SOUNDS = [
  ["start", at("starting"), running],
  ["arrival", running, at("finished", { moved: true, ending })],
  ["collision", running, at("failed", { ending: blocked })],
] as const;

test.each(
  SOUNDS,
)("%s sounds at its moment, which the status line tells too", (name, before, now) => {
  expect(soundBetween(before, now)).toBe(name);
  const context = { texts: textsOf("pt-BR"), language: "pt-BR", parameterOf: () => 1 } as const;
  const [shown, shownBefore] = [now, before].map((view) => sentenceOf(view, context));
  expect(shown).not.toEqual(shownBefore);
  expect(shown?.text).toBeTruthy();
});

test.each([
  ["another run", at("starting"), { ...running, run: "other" }],
  ["a run that goes on after a pause", at("paused"), running],
  ["a pause", running, at("paused")],
  ["a program that only calculates", running, at("finished", { ending })],
  ["somebody stops it", running, at("stopped", { moved: true, ending })],
  ["a fault of the program", running, at("failed", { moved: true, ending })],
])("%s is silent", (_, before, now) => {
  expect(soundBetween(before, now)).toBeNull();
});
