import { expect, test } from "vitest";
import type { Proposal } from "../../api/model";
import { textsOf } from "../../i18n";
import {
  type CheckKind,
  type Choices,
  checksOf,
  choicesOf,
  offered,
  proposed,
} from "./check_choices";
import { CHECK_FIELDS } from "./check_fields";
import { criteriaOf } from "./criteria";

const PROPOSAL: Proposal = {
  finished: true,
  zones: ["casa", "escola", "praça"],
  checks: [
    { check: "ends_in", zone: "escola" },
    { check: "ends_at", x_m: 2, y_m: -1, within_m: 0.1 },
    { check: "visits", zones: ["casa", "escola"] },
    { check: "touches_nothing" },
    { check: "path_length", at_least_m: 4, at_most_m: 4.4 },
    { check: "block_count", at_most: 6 },
    { check: "nesting", at_least: 1 },
    { check: "says", text: "oi" },
  ],
};
const KINDS = PROPOSAL.checks.map(({ check }) => check as CheckKind);

const withAll = (choices: Choices, on: readonly CheckKind[]): Choices =>
  Object.fromEntries(
    offered(choices).map(([kind, chosen]) => [kind, { ...chosen, on: on.includes(kind) }]),
  );

const with15Cm = (choices: Choices): Choices => ({
  ...choices,
  ends_at: { on: true, check: { ...choices.ends_at?.check, within_m: 0.15 } },
});

test("nothing is chosen at first, in the order of the form", () => {
  const choices = proposed(PROPOSAL);
  expect(checksOf(choices)).toEqual([]);
  expect(offered(choices).map(([kind]) => kind)).toEqual(KINDS);
});

test("what was chosen becomes checks, and checks become the same choices again", () => {
  const choices = with15Cm(withAll(proposed(PROPOSAL), KINDS));
  const checks = checksOf(choices);
  expect(checks).toContainEqual({ check: "ends_at", x_m: 2, y_m: -1, within_m: 0.15 });
  expect(checks).toHaveLength(KINDS.length);
  const { formChoices, others } = choicesOf(checks);
  expect(others).toEqual([]);
  expect(checksOf(proposed(PROPOSAL, formChoices))).toEqual(checks);
});

test("another solution moves what it does and keeps what the teacher wrote", () => {
  const chosen = with15Cm(withAll(proposed(PROPOSAL), ["ends_at", "visits"]));
  const checks = [
    { check: "ends_at", x_m: 3, y_m: 0, within_m: 0.1 },
    { check: "visits", zones: ["praça"] },
  ];
  expect(checksOf(proposed({ ...PROPOSAL, checks }, chosen))).toEqual([
    { check: "ends_at", x_m: 3, y_m: 0, within_m: 0.15 },
    { check: "visits", zones: ["praça"] },
  ]);
});

test("a check that the form does not offer stays as it is", () => {
  const foreign = [
    { check: "symmetric", axes: 2 },
    { check: "nesting", at_least: 2 },
  ];
  expect(choicesOf([...foreign, { check: "touches_nothing" }]).others).toEqual(foreign);
});

test("what the solution does not do is no longer checked", () => {
  const chosen = withAll(proposed(PROPOSAL), ["says", "block_count"]);
  const reducedProposal = {
    ...PROPOSAL,
    checks: PROPOSAL.checks.filter(({ check }) => check !== "says"),
  };
  expect(checksOf(proposed(reducedProposal, chosen))).toEqual([
    { check: "block_count", at_most: 6 },
  ]);
});

test("what counts is said in pupils' words with the numbers", () => {
  const texts = textsOf("pt-BR").making;
  const some: CheckKind[] = ["ends_in", "visits", "path_length", "block_count", "nesting"];
  expect(criteriaOf(withAll(proposed(PROPOSAL), some), texts)).toBe(
    "Vale: terminar em escola; passar por casa, escola, nessa ordem; um caminho de 4 a 4,4 m; até 6 blocos; usar uma repetição.",
  );
  expect(criteriaOf(with15Cm({}), texts)).toContain("até 15 cm");
  expect(criteriaOf(proposed(PROPOSAL), texts)).toBe("");
});

test.each([
  "pt-BR",
  "en",
  "es",
] as const)("every kind that is offered has words in %s", (language) => {
  const { kinds, criteria } = textsOf(language).making;
  const written = Object.keys(CHECK_FIELDS).sort();
  expect(Object.keys(kinds).sort()).toEqual(written);
  expect(Object.keys(criteria).sort()).toEqual(written);
});
