import type { Texts } from "../../i18n";
import {
  type Check,
  type CheckField,
  type CheckKind,
  type Choices,
  chosen,
  fieldsOf,
  shownNumber,
} from "./check_choices";

type MakingTexts = Texts["making"];

/** The chosen checks as a text for pupils, with values; "" if none is chosen. */
export function criteriaOf(choices: Choices, texts: MakingTexts): string {
  const parts = chosen(choices).map(([kind, { check }]) => partOf(kind, check, texts));
  return parts.length > 0 ? texts.counts(parts.join("; ")) : "";
}

/** The text of a check. Its function gets the values of the form's fields, in their order. */
function partOf(kind: CheckKind, check: Check, texts: MakingTexts): string {
  const text: unknown = texts.criteria[kind];
  if (typeof text !== "function") return String(text);
  return text(...fieldsOf(kind).map((field) => shown(field, check)));
}

const shown = (field: CheckField, check: Check) =>
  field.input === "number" ? shownNumber(field, check) : [check[field.key]].flat().join(", ");
