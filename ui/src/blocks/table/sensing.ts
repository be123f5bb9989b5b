import type { BlockArgument, BlockDefinition } from "../definition";
import { colourOptions, dropdown, TEXT_LITERAL } from "./arguments";
import { SENSOR_ROWS } from "./sensor_rows";

type SensorRow = (typeof SENSOR_ROWS)[number];

/**
 * The field that chooses one of several sensors. Saved workspaces contain this name, so it cannot
 * change.
 */
export const CHOSEN_SENSOR = "AXIS";

/**
 * Arguments of a sensor block: the chosen sensor, then a choice or a number that may be computed.
 */
function argumentsOfSensor({ sensors, asked }: SensorRow): BlockArgument[] {
  const choice: BlockArgument[] =
    sensors.length > 1
      ? [
          dropdown(
            CHOSEN_SENSOR,
            sensors.map((name) => [name, name]),
          ),
        ]
      : [];
  if (!asked) return choice;
  const { key } = asked;
  const name = key.toUpperCase();
  if ("choices" in asked) {
    const options = asked.choices.map((one) => [`%{BKY_PINEL_${one.toUpperCase()}}`, one]);
    return [...choice, { type: "field_dropdown", name, key, options }];
  }
  const { start, limits } = asked;
  const shadow = { number: start };
  return [...choice, { type: "input_value", name, key, check: "Number", shadow, limits }];
}

const blocks = SENSOR_ROWS.map(
  (row) =>
    ({
      type: row.type,
      style: "sensing",
      level: row.level,
      makes: { sensor: row.sensors },
      args0: argumentsOfSensor(row),
      output: row.gives,
    }) as const,
);

const colour = {
  type: "colour",
  style: "sensing",
  level: 2,
  makes: { expression: "literal" },
  args0: [dropdown("COLOUR", colourOptions)],
  output: TEXT_LITERAL,
} as const;

/** The blocks of `sensor_rows.ts`, and the colours to compare the floor with. */
export const sensing = [
  ...blocks.filter(({ level }) => level === 2),
  colour,
  ...blocks.filter(({ level }) => level === 3),
] as const satisfies readonly BlockDefinition[];
