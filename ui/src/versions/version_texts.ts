import type { VersionSummary } from "../api/model";

import type { Language, Texts } from "../i18n";
import { faceOf, type Section, type VersionStep } from "./line";

/** Facts about a version besides its time, the most important first. */
export function factsOf(version: VersionSummary, texts: Texts): string[] {
  const { archive, work } = texts;
  const facts: string[] = [];
  if (version.n_passed > 0) facts.push(archive.passed);
  if (version.n_runs > 0) facts.push(work.runCount({ count: version.n_runs }));
  else if (!version.can_run) facts.push(archive.incomplete);
  return facts;
}

/**
 * Label of a step in the list, and further facts about it.
 *
 * @param setup Changes of the step besides blocks; the label of a step that changed no blocks.
 */
export function stepText(step: VersionStep, setup: readonly string[], texts: Texts) {
  const face = faceOf(step);
  const [fact] = factsOf({ ...face, can_run: true }, texts);
  const known = face.label || fact;
  const n = changesIn(step);
  if (!known && n === 0 && setup.length > 0) return { label: setup.join(" · "), facts: [] };
  const facts = [...(face.label ? factsOf(face, texts) : []), ...setup];
  return { label: known || texts.archive.changes({ count: n }), facts };
}

/** Number of versions of a step that changed blocks. */
export function changesIn({ versions }: VersionStep): number {
  return versions.filter(({ setup_only }) => !setup_only).length;
}

/** Time of day, such as "10:32". */
export function timeOf(iso: string, language: Language): string {
  return new Date(iso).toLocaleTimeString(language, { timeStyle: "short" });
}

/** Time span, such as "10:02–10:05" or "10:02". */
export function spanOf(from: string, to: string, language: Language): string {
  const [first, last] = [timeOf(from, language), timeOf(to, language)];
  return first === last ? first : `${first}–${last}`;
}

/** Day and time span of a section, such as "ontem, 09:10–09:25". */
export function sectionText(section: Section, now: Date, language: Language, texts: Texts) {
  const then = new Date(section.from);
  const days = midnight(now) - midnight(then);
  const span = spanOf(section.from, section.to, language);
  if (days === 0) return texts.units.today({ time: span });
  if (days === 1) return texts.units.yesterday({ time: span });
  const sameYear = then.getFullYear() === now.getFullYear();
  const day = then.toLocaleDateString(language, {
    day: "numeric",
    month: "long",
    ...(sameYear ? {} : { year: "numeric" }),
  });
  return `${day}, ${span}`;
}

/** Short day, such as "19 de nov." or "hoje". */
export function dayText({ from }: Section, now: Date, language: Language, texts: Texts): string {
  const then = new Date(from);
  const days = midnight(now) - midnight(then);
  if (days === 0) return texts.archive.today;
  if (days === 1) return texts.archive.yesterday;
  return then.toLocaleDateString(language, { day: "numeric", month: "short" });
}

function midnight(date: Date): number {
  return Math.round(
    new Date(date.getFullYear(), date.getMonth(), date.getDate()).getTime() / 864e5,
  );
}

/** Creation time of a version, such as "hoje, 10:32" or "19 de novembro, 10:32". */
export function createdText(
  { created_at }: VersionSummary,
  language: Language,
  texts: Texts,
): string {
  const alone = { from: created_at, to: created_at, items: [] };
  return sectionText(alone, new Date(), language, texts);
}

/** Text of a version in one line, for lists of options. */
export function versionLine(version: VersionSummary, language: Language, texts: Texts): string {
  const about = version.label || factsOf(version, texts)[0];
  const made = createdText(version, language, texts);
  return [texts.archive.version({ n: version.number }), about, made].filter(Boolean).join(" · ");
}
