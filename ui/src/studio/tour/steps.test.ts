import { describe, expect, test } from "vitest";
import {
  advanced,
  after,
  beginning,
  MISSION_STEPS,
  type Progress,
  STEPS,
  type StudioState,
} from "./steps";

const NOTHING: StudioState = { actions: [], run: null, isRunning: false };
const stateWith = (more: Partial<StudioState>): StudioState => ({ ...NOTHING, ...more });

/** The steps that the pupils reach, one after each state of the studio. */
function walk(...states: StudioState[]): string[] {
  let now: Progress = after(beginning(NOTHING), NOTHING);
  return states.map((state) => {
    now = advanced(now, state);
    return `${now.step}${now.isOther ? " (other)" : ""}`;
  });
}

describe("the guided first drive", () => {
  test("goes on by what is done, to the end", () => {
    const [one, two] = [["move_forward"], ["move_forward", "turn"]];
    expect(
      walk(
        NOTHING,
        stateWith({ actions: one }),
        stateWith({ actions: one, run: "1", isRunning: true }),
        stateWith({ actions: one, run: "1" }),
        stateWith({ actions: two, run: "1" }),
        stateWith({ actions: two, run: "2", isRunning: true }),
        stateWith({ actions: two, run: "2" }),
      ),
    ).toEqual(["move", "run", "watch", "turn", "again", "again", "end"]);
  });

  test("in a mission ends after the first run", () => {
    const started = after(beginning(NOTHING), NOTHING, MISSION_STEPS);
    const run = { actions: ["move_forward"], run: "1" };
    expect(advanced(started, stateWith(run), MISSION_STEPS).step).toBe("end");
    expect(advanced(started, stateWith(run)).step).toBe("turn");
  });

  test("takes another block too, and says so until the next one", () => {
    expect(
      walk(
        stateWith({ actions: ["beep"] }),
        stateWith({ actions: ["beep"], run: "1" }),
        stateWith({ actions: ["beep", "stop"], run: "1" }),
      ),
    ).toEqual(["run (other)", "turn", "again (other)"]);
  });

  test("needs no greeting for who takes a block at once", () => {
    const first = beginning(NOTHING);
    expect(advanced(first, stateWith({ actions: ["move_forward"] })).step).toBe("run");
    expect(advanced(first, NOTHING).step).toBe("hello");
  });

  test("counts a block that is put in another's place", () => {
    const before = stateWith({ actions: ["move_forward"], run: "1" });
    const [at, now] = [beginning(before, "turn"), stateWith({ actions: ["turn"], run: "1" })];
    expect(advanced(at, now)).toMatchObject({ step: "again", isOther: false });
    expect(advanced(at, stateWith({ run: "1" })).step).toBe("turn");
  });

  test("goes on in a page that was loaded again; a run that is gone is repeated", () => {
    const before = stateWith({ actions: ["move_forward"] });
    expect(STEPS.map((step) => beginning(before, step).step)).toEqual(
      STEPS.map((step) => (step === "watch" ? "run" : step)),
    );
    const running = { ...before, run: "1", isRunning: true };
    expect(advanced(beginning(before, "watch"), running).step).toBe("watch");
  });

  test("keeps for the run what was said about the block", () => {
    const other = stateWith({ actions: ["beep"], run: "1", isRunning: true });
    expect(walk(stateWith({ actions: ["beep"] }), other)).toEqual(["run (other)", "watch (other)"]);
  });

  test("does not go on while a block is missing or a run goes on", () => {
    expect(walk(NOTHING, NOTHING)).toEqual(["move", "move"]);
    const running = stateWith({ actions: ["turn"], run: "1", isRunning: true });
    expect(walk(running, running).at(-1)).toBe("watch (other)");
  });
});
