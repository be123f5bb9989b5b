import type { Measured } from "../../api/model";
import type { Texts } from "../../i18n";
import { CHECK_KINDS, type CheckKind, type Choices, rowOf } from "./check_rows";

type Say = Texts["making"];

/** What counts, in pupils' words with numbers; "" where nothing was chosen. */
export function criteriaOf(choices: Choices, measured: Measured, say: Say): string {
  const chosen = CHECK_KINDS.filter(
    (kind) => choices[kind].on && rowOf(kind).isOffered(measured),
  ).map((kind) => partOf(kind, choices, measured, say));
  return chosen.length > 0 ? say.counts(chosen.join("; ")) : "";
}

function partOf(kind: CheckKind, choices: Choices, measured: Measured, say: Say): string {
  const { numbers, text } = choices[kind];
  const { least = 0, most = 0, cm = 0, n = 0 } = numbers;
  const words = say.criteria;
  switch (kind) {
    case "ends_in":
      return words.ends_in(text);
    case "visits":
      return words.visits(measured.zones.join(", "));
    case "says":
      return words.says(text);
    case "ends_at":
    case "draws":
      return words[kind](cm);
    case "turned_total":
    case "path_length":
      return words[kind](least, most);
    case "block_count":
    case "time":
      return words[kind](most);
    case "mark_count":
      return words.mark_count(n);
    default:
      return words[kind];
  }
}
