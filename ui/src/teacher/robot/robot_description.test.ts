import { expect, test } from "vitest";
import type { RealRobot, RobotField } from "../../api/model";
import { descriptionOf, draftOf } from "./robot_description";

const field = (name: string, more: Partial<RobotField> = {}): RobotField => ({
  name,
  part: "speed",
  label: name,
  hint: "",
  low: null,
  high: null,
  is_whole: false,
  is_list: false,
  ...more,
});

const fields = [
  field("max_v_mps", { low: 0.05, high: 1.2 }),
  field("host"),
  field("peers", { is_list: true }),
  field("room.width_m", { low: 1, high: 50 }),
];
const record = { max_v_mps: 0.3, host: "127.0.0.1", peers: ["a", "b"], room: { width_m: 2.5 } };

test("a record comes back from its form, whatever the language's decimal sign is", () => {
  for (const locale of ["pt-BR", "en"]) {
    const draft = draftOf({ record, fields } as unknown as RealRobot, locale);
    expect(descriptionOf(fields, draft)).toEqual(record);
  }
  expect(draftOf({ record, fields } as unknown as RealRobot, "pt-BR")["room.width_m"]).toBe("2,5");
});

test("what is no number is left to the server to name", () => {
  const typed = { max_v_mps: "rápido", host: " a ", peers: " , c,", "room.width_m": "" };
  expect(descriptionOf(fields, typed)).toEqual({
    max_v_mps: "rápido",
    host: "a",
    peers: ["c"],
    room: { width_m: "" },
  });
});
