import { expect, test } from "vitest";
import type { Measured } from "../../api/model";
import { textsOf } from "../../i18n";
import {
  CHECK_KINDS,
  type CheckKind,
  type Choices,
  checksOf,
  choicesOf,
  proposed,
  rowOf,
} from "./check_rows";
import { criteriaOf } from "./criteria";

const MEASURED: Measured = {
  finished: true,
  touched: false,
  end_x_m: 2,
  end_y_m: -1,
  heading_deg: 90,
  path_m: 4.24,
  turned_deg: 360,
  net_deg: 360,
  time_s: 12.3,
  n_blocks: 6,
  n_nested: 1,
  n_marks: 1,
  zones: ["casa", "escola"],
  end_zone: "escola",
  all_zones: ["casa", "escola", "praça"],
  said: ["oi"],
  gap_m: 0.01,
  template: [
    [
      [0, 0],
      [1, 0],
    ],
  ],
};

const withAll = (choices: Choices, on: readonly CheckKind[]): Choices =>
  Object.fromEntries(
    CHECK_KINDS.map((kind) => [kind, { ...choices[kind], on: on.includes(kind) }]),
  ) as unknown as Choices;

test("nothing is chosen at first, and the numbers are those of the solution", () => {
  const choices = proposed(MEASURED);
  expect(checksOf(choices, MEASURED)).toEqual([]);
  expect(choices.block_count.numbers).toEqual({ most: 6 });
  expect(choices.path_length.numbers).toEqual({ least: 4, most: 4.4 });
  expect(choices.time.numbers).toEqual({ most: 19 });
  expect(choices.ends_in.text).toBe("escola");
});

test("what was chosen becomes checks, and checks become the same choices again", () => {
  const choices = withAll(proposed(MEASURED), CHECK_KINDS);
  const checks = checksOf(choices, MEASURED);
  expect(checks).toContainEqual({ check: "ends_at", x_m: 2, y_m: -1, within_m: 0.1 });
  expect(checks).toContainEqual({ check: "visits", zones: ["casa", "escola"] });
  expect(checks).toHaveLength(CHECK_KINDS.length);
  const { kept, others } = choicesOf(checks);
  expect(others).toEqual([]);
  expect(checksOf(proposed(MEASURED, kept), MEASURED)).toEqual(checks);
});

test("a check that the form does not offer stays as it is", () => {
  const foreign = { check: "symmetric", axes: 2 };
  expect(choicesOf([foreign, { check: "touches_nothing" }]).others).toEqual([foreign]);
});

test("what the solution does not do is not offered, and no longer checked", () => {
  const silent: Measured = { ...MEASURED, said: [], zones: [], end_zone: "", gap_m: null };
  const offered = CHECK_KINDS.filter((kind) => rowOf(kind).isOffered(silent));
  expect(offered).not.toContain("says");
  expect(offered).not.toContain("closed");
  expect(offered).not.toContain("ends_in");
  const chosen = withAll(proposed(MEASURED), ["says", "block_count"]);
  expect(checksOf(proposed(silent, chosen), silent)).toEqual([
    { check: "block_count", at_most: 6 },
  ]);
});

test("what counts is said in pupils' words with the numbers", () => {
  const say = textsOf("pt-BR").making;
  const choices = withAll(proposed(MEASURED), ["ends_in", "path_length", "block_count"]);
  expect(criteriaOf(choices, MEASURED, say)).toBe(
    "Vale: terminar em escola; um caminho de 4 a 4,4 m; até 6 blocos.",
  );
  expect(criteriaOf(proposed(MEASURED), MEASURED, say)).toBe("");
});
