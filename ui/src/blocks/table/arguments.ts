import { PROGRAM_LIMITS } from "../../api/declared";
import type { Limits, ValueType } from "../definition";

const { MAX_ANGLE_DEG, MAX_DISTANCE_M, MAX_LIST, MAX_REPEATS, MAX_WAIT_S } = PROGRAM_LIMITS;

/** Variables, calls and items of lists may be anything; what is written on a block itself they are not. */
const ANYTHING: readonly ValueType[] = ["Number", "String", "Boolean", "Array"];
/** Round, as most values are, though a truth value would have corners. */
export const anything = { output: ANYTHING, outputShape: 2 } as const;
export const NUMBER_LITERAL: readonly ValueType[] = ["Number", "Literal"];
export const TEXT_LITERAL: readonly ValueType[] = ["String", "Literal"];
export const BOOLEAN_LITERAL: readonly ValueType[] = ["Boolean", "Literal"];

export const DISTANCE: Limits = { min: 0, max: MAX_DISTANCE_M, precision: 0.01 };
export const PLACE: Limits = { min: -MAX_DISTANCE_M, max: MAX_DISTANCE_M, precision: 0.01 };
/** The side is chosen beside it. */
export const ANGLE: Limits = { min: 0, max: MAX_ANGLE_DEG, precision: 0.1 };
export const SECONDS: Limits = { min: 0, max: MAX_WAIT_S, precision: 0.1 };
export const TIMEOUT: Limits = { min: 0.1, max: MAX_WAIT_S, precision: 0.1 };
export const SPEED: Limits = { min: 0.01, precision: 0.01 };
export const POSITION: Limits = { min: 1, max: MAX_LIST, precision: 1 };
export const TIMES: Limits = { min: 0, max: MAX_REPEATS, precision: 1 };

/** A hole for a number, with one in it to begin with. */
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

/** A hole for any value, with a text in it to begin with: the key of its words. */
export function textInput(name: string, key: string, textKey: string) {
  return { type: "input_value", name, key, shadow: { textKey } } as const;
}

export function conditionInput(name: string, key: string) {
  return { type: "input_value", name, key, check: "Boolean" } as const;
}

/** The name of a variable, to be chosen or made. */
export function nameField(name: string, key: string) {
  return { type: "field_name", name, key } as const;
}

/** Commands inside a block. */
export const body = {
  message1: "%1",
  args1: [{ type: "input_statement", name: "DO", key: "commands" }],
} as const;

type Options = readonly (readonly [string, string])[];

export function choice(name: string, key: string, options: Options) {
  return { type: "field_dropdown", name, key, options } as const;
}

export const sides = {
  type: "field_dropdown",
  name: "DIRECTION",
  options: [
    ["%{BKY_PINEL_LEFT}", "LEFT"],
    ["%{BKY_PINEL_RIGHT}", "RIGHT"],
  ],
} as const;

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
