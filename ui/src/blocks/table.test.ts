import { describe, expect, test } from "vitest";
import type { BlockArgument } from "./definition";
import { ALL_DEFINITIONS, argumentsOf, type Row, type StatementBlockType } from "./definitions";
import { SPECIAL } from "./generator/commands";

interface Schema {
  const?: unknown;
  enum?: unknown[];
  anyOf?: Schema[];
  minimum?: number;
  maximum?: number;
  exclusiveMinimum?: number;
  properties?: Record<string, Schema>;
}

/** The published JSON schema of the server's reader. */
const [schema] = Object.values(
  import.meta.glob<{ $defs: Record<string, Schema> }>(
    "../../../pinel_desktop/program/schema.json",
    { eager: true, import: "default" },
  ),
);
const models = Object.values(schema?.$defs ?? {});

const IN_EVERY_COMMAND = ["action", "block", "comment"];

/** action -> parameter -> its schema. */
const ACTIONS = new Map(
  models.flatMap(({ properties = {} }) => {
    const action = properties.action?.const;
    if (typeof action !== "string") {
      const names = properties.action?.enum as string[] | undefined;
      return names?.[0] ? [[names[0], parametersIn(properties)] as const] : [];
    }
    return [[action, parametersIn(properties)] as const];
  }),
);

function parametersIn(properties: Record<string, Schema>): Record<string, Schema> {
  return Object.fromEntries(
    Object.entries(properties).filter(([name]) => !IN_EVERY_COMMAND.includes(name)),
  );
}

const COMMAND_ROWS = ALL_DEFINITIONS.flatMap((row) =>
  row.makes && "action" in row.makes ? [[row.type, row, row.makes] as const] : [],
);

/** Parameters that no input or field of the block is named after. */
const BY_HAND: Readonly<Record<string, readonly string[]>> = {
  if: ["condition", "commands", "elif", "else"],
  call: ["function", "arguments"],
};

function keysOf(row: Row): string[] {
  const { makes } = row;
  const fixed = makes && "action" in makes ? Object.keys(makes.fixed ?? {}) : [];
  const places = argumentsOf(row).flatMap(({ key }) => (key === undefined ? [] : [key]));
  return [...fixed, ...places, ...(BY_HAND[row.type] ?? [])];
}

test("there is a block for every action, and no other", () => {
  const made = new Set(COMMAND_ROWS.map(([, , { action }]) => action));
  expect([...made].sort()).toEqual([...ACTIONS.keys()].sort());
  expect(made.size).toBeGreaterThanOrEqual(30);
});

test.each([...ACTIONS])("the blocks of %s have all of its parameters", (action, parameters) => {
  const keys = COMMAND_ROWS.filter(([, , makes]) => makes.action === action).flatMap(([, row]) =>
    keysOf(row),
  );
  expect([...new Set(keys)].sort()).toEqual(Object.keys(parameters).sort());
});

describe.each(COMMAND_ROWS)("the places of %s", (type, row, { action }) => {
  const parameters = ACTIONS.get(action) ?? {};
  const places = (argumentsOf(row) as readonly BlockArgument[]).filter(({ key }) => key);

  test("hold a hand to what the reader takes", () => {
    const signed = type in SPECIAL && ["turn", "arc"].includes(type);
    for (const { key = "", type: kind, limits } of places) {
      if (kind !== "input_value") continue;
      const { minimum, maximum, exclusiveMinimum } = numberIn(parameters[key]);
      if (maximum !== undefined) expect(limits?.max, key).toBe(maximum);
      if (minimum !== undefined) {
        expect(limits?.min, key).toBe(signed && key === "angle" ? 0 : minimum);
      }
      if (exclusiveMinimum !== undefined) expect(limits?.min).toBeGreaterThan(exclusiveMinimum);
    }
  });

  test("offer every choice there is", () => {
    for (const { key = "", options } of places) {
      const choices = choicesIn(parameters[key]);
      if (!options || choices.length === 0) continue;
      const offered = (options as [string, string][]).map(([, value]) => value).filter(Boolean);
      expect([...offered].sort(), key).toEqual([...choices].sort());
    }
  });
});

test("there is a block for every sensor and every operator", () => {
  const expected = models.flatMap(({ properties = {} }) => choicesIn(properties.sensor));
  expect(sensors().sort()).toEqual(expected.sort());
  expect(operators().sort()).toEqual([...OPERATORS].sort());
});

test("every block is an action, an expression, or what they hang on", () => {
  const others = ALL_DEFINITIONS.filter(({ makes }) => makes === null).map(({ type }) => type);
  expect(others).toEqual(["program_start"]);
  for (const type of Object.keys(SPECIAL)) {
    expect(COMMAND_ROWS.map(([name]) => name)).toContain(type as StatementBlockType);
  }
});

function numberIn(schema: Schema | undefined): Schema {
  const all = [schema ?? {}, ...(schema?.anyOf ?? [])];
  return Object.assign({}, ...all);
}

function choicesIn(schema: Schema | undefined): string[] {
  const all = [schema ?? {}, ...(schema?.anyOf ?? [])];
  return all.flatMap((one) =>
    one.const === undefined ? (one.enum ?? []) : [one.const],
  ) as string[];
}

function sensors(): string[] {
  return ALL_DEFINITIONS.flatMap(({ makes }) => (makes && "sensor" in makes ? makes.sensor : []));
}

function operators(): string[] {
  return ALL_DEFINITIONS.flatMap(({ makes }) => (makes && "op" in makes ? makes.op : []));
}

/** The operators of the language's definition. */
const OPERATORS = [
  ...["+", "-", "*", "/", "%", "**", "==", "!=", "<", "<=", ">", ">=", "and", "or", "not"],
  ...["min", "max", "abs", "round", "sqrt", "sin", "cos", "tan", "random_int", "join", "length"],
  "item",
  "contains",
  "position_of",
];
