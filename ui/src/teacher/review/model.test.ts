import { expect, test } from "vitest";
import { outcomeOf } from "./model";

test("a star is for a mission of the lesson; of another one only the end of the run is shown", () => {
  expect(outcomeOf({ state: "finished", passed: true })).toBe("passed");
  expect(outcomeOf({ state: "finished", passed: false })).toBe("notyet");
  const other_mission = "Labirinto";
  expect(outcomeOf({ state: "finished", passed: true, other_mission })).toBe("finished");
  expect(outcomeOf({ state: "finished", passed: false, other_mission })).toBe("finished");
  expect(outcomeOf({ state: "failed", passed: false, other_mission })).toBe("failed");
});
