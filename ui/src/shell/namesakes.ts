import type { Classroom } from "../api/model";
import type { Language } from "../i18n";

/**
 * Distinguishes classes of equal name: adds the PC of the first lesson, or the day of creation if
 * there was no lesson. If names are still equal, adds a number.
 */
export function withDistinctNames(classes: readonly Classroom[], language: Language): Classroom[] {
  const alone = single(classes.map(keyOf));
  const named = classes.map((one) =>
    alone.has(keyOf(one)) ? one : { ...one, name: `${one.name} · ${origin(one, language)}` },
  );
  const clear = single(named.map(keyOf));
  return named.map((one) =>
    clear.has(keyOf(one)) ? one : { ...one, name: `${one.name} (${ordinal(one, named)})` },
  );
}

/** Key under which names count as equal: ignores spaces and case, as the server does. */
const keyOf = ({ name }: Classroom) => name.normalize("NFKC").toLowerCase().replace(/\s/g, "");

function single(keys: readonly string[]): Set<string> {
  return new Set(keys.filter((key) => keys.indexOf(key) === keys.lastIndexOf(key)));
}

function origin({ computer, created_at }: Classroom, language: Language): string {
  const day = { day: "numeric", month: "short" } as const;
  return computer ?? new Date(created_at).toLocaleDateString(language, day);
}

function ordinal(one: Classroom, named: readonly Classroom[]): number {
  return named.filter((other) => keyOf(other) === keyOf(one)).indexOf(one) + 1;
}
