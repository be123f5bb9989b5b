import type { Classroom } from "../api/model";
import type { Language } from "../i18n";

/** Two PCs may each have made a class of one name: then the name tells the PC too, or the day before there was a lesson. */
export function toldApart(classes: readonly Classroom[], language: Language): Classroom[] {
  const alone = single(classes.map(keyOf));
  const named = classes.map((one) =>
    alone.has(keyOf(one)) ? one : { ...one, name: `${one.name} · ${origin(one, language)}` },
  );
  const clear = single(named.map(keyOf));
  return named.map((one) =>
    clear.has(keyOf(one)) ? one : { ...one, name: `${one.name} (${place(one, named)})` },
  );
}

/** Names that people take for one: as the server compares them, spaces and capitals do not count. */
const keyOf = ({ name }: Classroom) => name.normalize("NFKC").toLowerCase().replace(/\s/g, "");

function single(keys: readonly string[]): Set<string> {
  return new Set(keys.filter((key) => keys.indexOf(key) === keys.lastIndexOf(key)));
}

function origin({ computer, created_at }: Classroom, language: Language): string {
  const day = { day: "numeric", month: "short" } as const;
  return computer ?? new Date(created_at).toLocaleDateString(language, day);
}

function place(one: Classroom, named: readonly Classroom[]): number {
  return named.filter((other) => keyOf(other) === keyOf(one)).indexOf(one) + 1;
}
