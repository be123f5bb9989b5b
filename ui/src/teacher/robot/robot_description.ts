import type { RealRobot, RobotField } from "../../api/model";
import { numberIn } from "../../kit/NumberField";

export type Draft = Readonly<Record<string, string>>;
type Values = Readonly<Record<string, unknown>>;

/** Initial texts of a robot's form: each field of its description as text. */
export function draftOf({ record, fields }: RealRobot, locale: string): Record<string, string> {
  return Object.fromEntries(
    fields.map((field) => [field.name, written(valueAt(record ?? {}, field.name), locale)]),
  );
}

/** The robot description from the typed texts. A text that is no number stays: the server reports the fault. */
export function descriptionOf(
  fields: readonly RobotField[],
  draft: Draft,
): Record<string, unknown> {
  const own: Record<string, unknown> = {};
  const room: Record<string, unknown> = {};
  for (const field of fields) {
    const [first, inner] = field.name.split(".");
    const value = typedOf(field, draft[field.name] ?? "");
    if (inner) room[inner] = value;
    else if (first) own[first] = value;
  }
  return { ...own, room };
}

/** The fields of a room's start. */
export function startAt(
  place: { x_m: number; y_m: number; heading_deg: number },
  locale: string,
): Draft {
  return {
    "room.x_m": written(place.x_m, locale),
    "room.y_m": written(place.y_m, locale),
    "room.heading_deg": written(place.heading_deg, locale),
  };
}

function valueAt(record: Values, name: string): unknown {
  const [first = "", inner] = name.split(".");
  const value = record[first];
  return inner ? (value as Values | undefined)?.[inner] : value;
}

function written(value: unknown, locale: string): string {
  if (typeof value === "number") {
    return value.toLocaleString(locale, { maximumFractionDigits: 3, useGrouping: false });
  }
  return Array.isArray(value) ? value.join(", ") : String(value ?? "");
}

function typedOf({ low, is_list }: RobotField, text: string): unknown {
  if (low !== null) return numberIn(text) ?? text;
  const parts = text.split(",").map((part) => part.trim());
  return is_list ? parts.filter(Boolean) : text.trim();
}
