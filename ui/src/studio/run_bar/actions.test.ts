import { describe, expect, test } from "vitest";
import { textsOf } from "../../i18n";
import { LANGUAGES } from "../../i18n/languages";
import type { Phase } from "../../run/reducer";
import type { StudioControl } from "../studio_control";
import { ACTIONS, actionFor, type RunState } from "./actions";

const state = (phase: Phase, more: Partial<RunState> = {}): RunState => ({
  phase,
  unable: false,
  inFunction: false,
  stepwise: true,
  ...more,
});

const PHASES: readonly Phase[] = ["idle", "starting", "running", "paused", "finished", "failed"];
const NO_MODIFIERS = { shiftKey: false, ctrlKey: false, altKey: false, metaKey: false };
const key = (name: string, modifiers: object = {}) => ({
  key: name,
  ...NO_MODIFIERS,
  ...modifiers,
});

/** The calls that an action makes, as texts. */
function performed(name: string, now: RunState): string[] {
  const done: string[] = [];
  const control = {
    stop: () => done.push("stop"),
    run: (paused = false) => done.push(paused ? "run paused" : "run"),
    send: (command: object) => done.push(Object.values(command).join(" ")),
  };
  const action = ACTIONS.find((one) => one.name === name);
  action?.perform(control as unknown as StudioControl, now);
  return done;
}

describe("the actions of a run", () => {
  test.each(PHASES)("have a shortcut each that means one thing (%s)", (phase) => {
    const shown = ACTIONS.filter((one) => one.isShown(state(phase, { inFunction: true })));
    const shortcuts = shown.map((one) => one.shortcut);
    expect(new Set(shortcuts).size).toBe(shortcuts.length);
  });

  test("have words in every language", () => {
    for (const texts of LANGUAGES.map(textsOf)) {
      for (const action of ACTIONS) {
        expect(action.label(texts, state("paused"))).not.toBe("");
        expect(action.help?.(texts)).not.toBe("");
      }
    }
  });

  test.each([
    ["run", state("idle"), ["run"]],
    ["pause", state("running"), ["pause"]],
    ["resume", state("paused"), ["resume"]],
    ["stop", state("running"), ["stop"]],
    ["step", state("idle"), ["run paused"]],
    ["step", state("paused"), ["step into"]],
    ["over", state("paused"), ["step over"]],
    ["out", state("paused"), ["step out"]],
  ])("do what they are called: %s", (name, now, done) => {
    expect(performed(name, now)).toEqual(done);
  });
});

describe("a key", () => {
  test.each([
    ["F8", {}, state("idle"), "run"],
    ["F8", {}, state("running"), "pause"],
    ["F8", {}, state("paused"), "resume"],
    ["F8", { shiftKey: true }, state("idle"), "stop"],
    ["F7", {}, state("paused"), "step"],
    ["F10", {}, state("paused"), "over"],
    ["F7", { shiftKey: true }, state("paused", { inFunction: true }), "out"],
  ])("stands for what its button shows: %s", (name, modifiers, now, action) => {
    expect(actionFor(key(name, modifiers), now)?.name).toBe(action);
  });

  test.each([
    ["F8", {}, state("starting")],
    ["F8", {}, state("idle", { unable: true })],
    ["F8", { ctrlKey: true }, state("idle")],
    ["F7", {}, state("paused", { stepwise: false })],
    ["F10", {}, state("running")],
    ["Enter", {}, state("idle")],
  ])("does nothing where its button would not: %s", (name, modifiers, now) => {
    expect(actionFor(key(name, modifiers), now)).toBeUndefined();
  });
});
