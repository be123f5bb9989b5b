import { PROGRAM_LIMITS } from "../../api/declared";
import type { Limits, ValueType } from "../definition";

const { MAX_ANGLE_DEG, MAX_DISTANCE_M, MAX_LIST, MAX_REPEATS, MAX_WAIT_S } = PROGRAM_LIMITS;

/**
 * The type of variables, calls and list items, which is known only at run time. Literals have a
 * narrower type.
 */
const ANYTHING: readonly ValueType[] = ["Number", "String", "Boolean", "Array"];
/** A round output although the value may be a truth value, whose blocks have corners. */
export const anything = { output: ANYTHING, outputShape: 2 } as const;
export const NUMBER_LITERAL: readonly ValueType[] = ["Number", "Literal"];
export const TEXT_LITERAL: readonly ValueType[] = ["String", "Literal"];
export const BOOLEAN_LITERAL: readonly ValueType[] = ["Boolean", "Literal"];

export const DISTANCE: Limits = { min: 0, max: MAX_DISTANCE_M, precision: 0.01 };
export const PLACE: Limits = { min: -MAX_DISTANCE_M, max: MAX_DISTANCE_M, precision: 0.01 };
/** An angle without sign; a separate field chooses the side. */
export const ANGLE: Limits = { min: 0, max: MAX_ANGLE_DEG, precision: 0.1 };
export const SECONDS: Limits = { min: 0, max: MAX_WAIT_S, precision: 0.1 };
export const TIMEOUT: Limits = { min: 0.1, max: MAX_WAIT_S, precision: 0.1 };
export const SPEED: Limits = { min: 0.01, precision: 0.01 };
export const POSITION: Limits = { min: 1, max: MAX_LIST, precision: 1 };
export const TIMES: Limits = { min: 0, max: MAX_REPEATS, precision: 1 };

/** The type of a block that generates the command of that name. */
export function command<T extends string>(type: T) {
  return { type, makes: { action: type } } as const;
}

/** An input for a number, with a number as its placeholder. */
export function numberInput(name: string, key: string, start: number, limits: Limits = {}) {
  return {
    type: "input_value",
    name,
    key,
    check: "Number",
    shadow: { number: start },
    limits,
  } as const;
}

/** An input for any value; `textKey` is the key of its placeholder text. */
export function textInput(name: string, key: string, textKey: string) {
  return { type: "input_value", name, key, shadow: { textKey } } as const;
}

export function conditionInput(name: string, key: string) {
  return { type: "input_value", name, key, check: "Boolean" } as const;
}

/** A field to choose a variable or to create one. */
export function nameField(name: string, key: string) {
  return { type: "field_name", name, key } as const;
}

/** A statement input for the commands inside a block. */
export const body = {
  message1: "%1",
  args1: [{ type: "input_statement", name: "DO", key: "commands" }],
} as const;

type Options = readonly (readonly [string, string])[];

export function choice(name: string, key: string, options: Options) {
  return { type: "field_dropdown", name, key, options } as const;
}

/** A field whose value the generator of its block reads. */
export function dropdown(name: string, options: Options) {
  return { type: "field_dropdown", name, options } as const;
}

/** The type of a block that generates an operation of one operator. */
export function operation<T extends string>(type: T, op: string = type) {
  return { type, makes: { op: [op] } } as const;
}

export const sides = dropdown("DIRECTION", [
  ["%{BKY_PINEL_LEFT}", "LEFT"],
  ["%{BKY_PINEL_RIGHT}", "RIGHT"],
]);

export const COLOURS = [
  "blue",
  "red",
  "green",
  "yellow",
  "orange",
  "purple",
  "black",
  "white",
] as const;

export const colourOptions: Options = COLOURS.map((colour) => [
  `%{BKY_PINEL_COLOUR_${colour.toUpperCase()}}`,
  colour,
]);
