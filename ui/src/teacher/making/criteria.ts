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
  return parts.length > 0 ? texts.counts({ what: parts.join("; ") }) : "";
}

/** The text of a check, with the values of the form's fields by their labels, or else by their keys. */
function partOf(kind: CheckKind, check: Check, texts: MakingTexts): string {
  const text: unknown = texts.criteria[kind];
  if (typeof text !== "function") return String(text);
  const values = Object.fromEntries(
    fieldsOf(kind).map((field) => [nameOf(field), shown(field, check)]),
  );
  return text({ ...values, count: check.n });
}

const nameOf = (field: CheckField) => ("label" in field ? field.label : field.key);

const shown = (field: CheckField, check: Check) =>
  field.input === "number" ? shownNumber(field, check) : [check[field.key]].flat().join(", ");
