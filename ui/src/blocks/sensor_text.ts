import type { BlockArgument } from "./definition";
import { sensorRow } from "./definitions";
import { blockText, type TextKey } from "./texts";

/** The text of a sensor on its block, in the current language, such as "sonar 3 (m)". */
export function sensorText(reading: { readonly sensor: string }): string {
  const row = sensorRow(reading.sensor);
  const values = (row.args0 as readonly BlockArgument[]).map(({ key, type }) => {
    const value = String((reading as Record<string, unknown>)[key ?? "sensor"]);
    return key && type === "field_dropdown" ? blockText(value.toUpperCase() as TextKey) : value;
  });
  return blockText(row.type.toUpperCase() as TextKey, ...values);
}
