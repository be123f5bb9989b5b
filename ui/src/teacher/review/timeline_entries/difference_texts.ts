import type { BlockChange, ChangeCounts, VersionDifference } from "../../../api/model";
import { ALL_DEFINITIONS, argumentsOf } from "../../../blocks/definitions";
import type { TextKey } from "../../../blocks/texts";
import { type Language, type Texts, textsOf } from "../../../i18n";

/** Maximum number of listed changes. */
export const MAX_LISTED = 4;

const ROWS = new Map<string, (typeof ALL_DEFINITIONS)[number]>(
  ALL_DEFINITIONS.map((row) => [row.type, row]),
);

/** The text of a block without its inputs: "girar" for "%1 girar %2 %3 °". */
export function blockName(type: string, language: Language): string {
  const text = textsOf(language).blocks[type.toUpperCase() as TextKey];
  if (!text) return type;
  const parts = text
    .split(/%\d+/)
    .map((part) => part.replace(/[():,;]+/g, " ").trim())
    .filter((part) => /\p{L}{3}/u.test(part));
  return (parts.length > 0 ? parts.join("…") : text.replace(/%\d+/g, "…")).trim();
}

/** Number of differing blocks, as text. */
export function countTexts(changes: ChangeCounts, { line }: Texts["review"]): string[] {
  const kinds = ["added", "removed", "changed", "moved"] as const;
  const found = kinds
    .filter((kind) => changes[kind] > 0)
    .map((kind) => line[kind]({ count: changes[kind] }));
  return found.length > 0 ? found : [line.same];
}

/** Differences block by block: changed values first, then added, removed and moved blocks. */
export function differenceTexts(
  { added, removed, changed, moved }: VersionDifference,
  texts: Texts["review"],
  language: Language,
): string[] {
  const { difference } = texts;
  const name = ({ type }: { type: string }) => blockName(type, language);
  const found = [
    ...changed.flatMap(({ type, what }) => {
      const other = what.find((change) => change.name === "type");
      if (other)
        return difference.replaced({
          before: blockName(String(other.before), language),
          after: name({ type }),
        });
      return what.map((change) => changeText(type, change, texts, language));
    }),
    ...added.map((block) => difference.added({ block: name(block) })),
    ...removed.map((block) => difference.removed({ block: name(block) })),
    ...moved.map((block) => difference.moved({ block: name(block) })),
  ];
  const lines = counted(found, difference.times);
  if (lines.length <= MAX_LISTED) return lines;
  return [...lines.slice(0, MAX_LISTED), difference.more({ count: lines.length - MAX_LISTED })];
}

function counted(
  all: readonly string[],
  times: (values: { what: string; n: number }) => string,
): string[] {
  const counts = new Map<string, number>();
  for (const one of all) counts.set(one, (counts.get(one) ?? 0) + 1);
  return [...counts].map(([what, n]) => (n === 1 ? what : times({ what, n })));
}

function changeText(
  type: string,
  { name, before, after }: BlockChange,
  { difference }: Texts["review"],
  language: Language,
): string {
  const block = blockName(type, language);
  if (name === "disabled") {
    return after === true ? difference.switchedOff({ block }) : difference.switchedOn({ block });
  }
  if (name === "comment") return difference.commented({ block });
  if (name.startsWith("extraState")) return difference.reshaped({ block });
  const value = (one: unknown) => valueText(type, name, one, language) ?? difference.nothing;
  return difference.changed({ block, before: value(before), after: value(after) });
}

function valueText(type: string, name: string, value: unknown, language: Language): string | null {
  if (value === null || value === undefined || value === "") return null;
  if (typeof value === "number") {
    return value.toLocaleString(language, { maximumFractionDigits: 3, useGrouping: false });
  }
  if (typeof value !== "string") return null;
  return optionText(type, name, value, language) ?? textsOf(language).show.quoted({ text: value });
}

/** Text of a dropdown option on the block. */
function optionText(type: string, name: string, value: string, language: Language): string | null {
  const row = ROWS.get(type);
  const field = row && argumentsOf(row).find((argument) => argument.name === name);
  const options = field?.options as readonly (readonly [string, string])[] | undefined;
  const label = options?.find?.(([, key]) => key === value)?.[0];
  if (!label) return null;
  return label.replace(/%\{BKY_PINEL_(\w+)\}/g, (_, key: string) => {
    return textsOf(language).blocks[key as TextKey] ?? key;
  });
}
