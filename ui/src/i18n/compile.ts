import type { Language } from "../api/model";

/** Values of placeholders. */
export type Values = Readonly<Record<string, string | number>>;

/** A part of the catalogue in the form of i18next JSON v4. */
export type Entry = string | readonly Entry[] | { readonly [key: string]: Entry };

/** A part of a language: its texts, and messages that keep the form of the catalogue. */
export interface Part {
  readonly texts: Entry;
  readonly messages: Readonly<Record<string, unknown>>;
}

const PLACEHOLDER = /\{\{(\w+)(, number)?\}\}/g;
const PLURAL = /^(\w+)_(?:zero|one|two|few|many|other)$/;

/**
 * Makes what the components read: a text without placeholders stays a string, others become functions of their values.
 * The forms of a plural ("runs_one", "runs_other") become one function of `count`.
 */
export function compile(entry: Entry, language: Language): unknown {
  if (typeof entry === "string") return compileText(entry, language);
  if (isList(entry)) return entry.map((one) => compile(one, language));
  const compiled: Record<string, unknown> = {};
  for (const [key, one] of Object.entries(entry)) {
    const [, name] = PLURAL.exec(key) ?? [];
    if (name) compiled[name] ??= (values: Values) => plural(entry, name, values, language);
    else compiled[key] = compile(one, language);
  }
  return compiled;
}

const isList = (entry: Entry): entry is readonly Entry[] => Array.isArray(entry);

function compileText(text: string, language: Language): unknown {
  if (!text.includes("{{")) return text;
  return (values: Values) => interpolate(text, values, language);
}

function plural(
  forms: Readonly<Record<string, Entry>>,
  name: string,
  values: Values,
  language: Language,
): string {
  return interpolate(pluralForm(forms, name, Number(values.count), language), values, language);
}

/** The form for a count: that of 0 if there is one, then that of the language's rule, then the general one. */
export function pluralForm(
  forms: Readonly<Record<string, unknown>>,
  name: string,
  count: number,
  language: Language,
): string {
  const category = rules(language).select(count);
  const { [`${name}_zero`]: zero, [`${name}_${category}`]: form } = forms;
  return String((count === 0 ? zero : undefined) ?? form ?? forms[`${name}_other`]);
}

function interpolate(text: string, values: Values, language: Language): string {
  return text.replace(PLACEHOLDER, (whole, name: string, asNumber?: string) => {
    const { [name]: value } = values;
    if (value === undefined) return whole;
    return asNumber ? Number(value).toLocaleString(language) : String(value);
  });
}

const cache = new Map<Language, Intl.PluralRules>();

function rules(language: Language): Intl.PluralRules {
  const known = cache.get(language) ?? new Intl.PluralRules(language);
  cache.set(language, known);
  return known;
}
