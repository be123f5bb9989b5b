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

/** What counts, in pupils' words with numbers; "" where nothing was chosen. */
export function criteriaOf(choices: Choices, texts: MakingTexts): string {
  const parts = chosen(choices).map(([kind, { check }]) => partOf(kind, check, texts));
  return parts.length > 0 ? texts.counts(parts.join("; ")) : "";
}

/** The words of a kind, which take what the form shows of it in the order of its fields. */
function partOf(kind: CheckKind, check: Check, texts: MakingTexts): string {
  const text: unknown = texts.criteria[kind];
  if (typeof text !== "function") return String(text);
  return text(...fieldsOf(kind).map((field) => shown(field, check)));
}

const shown = (field: CheckField, check: Check) =>
  field.input === "number" ? shownNumber(field, check) : [check[field.key]].flat().join(", ");
