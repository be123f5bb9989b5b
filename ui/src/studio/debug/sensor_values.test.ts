import { expect, test } from "vitest";
import { sensorsIn } from "./sensor_values";

test("the sensors of a document are found once each, at any depth, in its order", () => {
  const near = { op: "<", args: [{ sensor: "sonar", index: 3 }, 1] };
  const document = {
    functions: [{ name: "f", commands: [{ action: "say", text: { sensor: "time" } }] }],
    commands: [
      { action: "while", condition: near, commands: [{ action: "wait_until", condition: near }] },
      { action: "say", text: { sensor: "sonar", index: { var: "i" } } },
    ],
  };
  expect(sensorsIn(document)).toEqual([{ sensor: "time" }, { sensor: "sonar", index: 3 }]);
  expect(sensorsIn(null)).toEqual([]);
});
