import type { Language, Texts } from "../i18n";
import { duration } from "../i18n/format";
import type { ReviewTexts } from "../i18n/review/pt-BR";
import { shortDay } from "./days";
import { countsInWords, differenceInWords } from "./difference_words";
import { outcomeOf, type ReviewMark, type VersionDifference } from "./model";

/** The marks of a group, and how its runs are counted. */
export class MarkBook {
  private readonly numbers = new Map<string, number>();
  private readonly repairedBy = new Map<string, ReviewMark>();

  /** `withDays`: a mark's time of day says nothing without its day. */
  constructor(
    readonly marks: readonly ReviewMark[],
    readonly withDays = false,
  ) {
    for (const mark of marks) {
      if (mark.run_id) this.numbers.set(mark.run_id, this.numbers.size + 1);
      if (mark.repairs) this.repairedBy.set(mark.repairs, mark);
    }
  }

  /** The runs of a group are counted from 1. */
  numberOf(run: string | null): number {
    return this.numbers.get(run ?? "") ?? 0;
  }

  /** The run that made this one good, if there is one. */
  repairOf(mark: ReviewMark): ReviewMark | null {
    return (mark.run_id && this.repairedBy.get(mark.run_id)) || null;
  }

  /** The mark whose versions tell what was changed: of a failing run the one that made it good. */
  changeOf(mark: ReviewMark): ReviewMark | null {
    const telling = this.repairOf(mark) ?? mark;
    return telling.changes ? telling : null;
  }
}

export interface Speech {
  readonly texts: ReviewTexts;
  readonly language: Language;
  readonly page: Texts;
}

/** What a mark is, in words; `difference` as far as it is known. */
export function wordsOf(
  mark: ReviewMark,
  book: MarkBook,
  difference: VersionDifference | null,
  speech: Speech,
): { title: string; lines: string[] } {
  const { texts } = speech;
  const changed = book.changeOf(mark);
  const changes = changed ? changesInWords(changed, difference, speech) : [];
  const lines = mark.kind === "run" ? aboutRun(mark, book, speech) : aboutEdits(mark, book, speech);
  if (changes.length > 0) {
    const begin = mark.kind === "run" ? `${texts.line.between} ` : "";
    lines.push(`${begin}${capital(changes.join("; "), begin === "")}.`);
  }
  return { title: titleOf(mark, book, speech), lines };
}

function titleOf(mark: ReviewMark, book: MarkBook, { texts, language }: Speech): string {
  const { line } = texts;
  if (mark.kind === "run") {
    const number = line.run(book.numberOf(mark.run_id));
    return `${number}: ${texts.outcomes[outcomeOf(mark)]}`;
  }
  const took = mark.until ? (Date.parse(mark.until) - Date.parse(mark.at)) / 1000 : 0;
  const edits = line.edits(mark.n_edits ?? 0);
  return took >= 1 ? `${edits} ${line.within(spell(took, language))}` : edits;
}

function aboutRun(mark: ReviewMark, book: MarkBook, speech: Speech): string[] {
  const { line } = speech.texts;
  const repair = book.repairOf(mark);
  return [
    mark.message,
    facts(mark, book, speech),
    mark.repairs && line.repairs(book.numberOf(mark.repairs)),
    repair && line.repairedBy(book.numberOf(repair.run_id)),
  ].filter((one): one is string => Boolean(one));
}

function aboutEdits(mark: ReviewMark, book: MarkBook, speech: Speech): string[] {
  return [facts(mark, book, speech)].filter(Boolean);
}

/** Program, when it was and how long the robot took. */
export function facts(mark: ReviewMark, book: MarkBook, speech: Speech): string {
  const { texts, language } = speech;
  const time = texts.detail.at(clock(mark.at, language));
  return [
    mark.program_name,
    book.withDays ? `${shortDay(Date.parse(mark.at) / 1000, language)} ${time}` : time,
    mark.duration_s ? duration(mark.duration_s, language) : null,
  ]
    .filter(Boolean)
    .join(" · ");
}

export function changesInWords(
  mark: ReviewMark,
  difference: VersionDifference | null,
  { texts, language }: Speech,
): string[] {
  if (difference && mark.since) return differenceInWords(difference, texts, language);
  return mark.changes ? countsInWords(mark.changes, texts) : [];
}

/** The time on the wall. */
export function clock(iso: string, language: Language): string {
  return new Date(iso).toLocaleTimeString(language, { hour: "numeric", minute: "2-digit" });
}

/** How long something took, without tenths of seconds. */
export function spell(seconds: number, language: Language): string {
  const whole = Math.round(seconds);
  if (whole < 60) return `${whole}\u00a0s`;
  const minutes = Math.floor(whole / 60);
  if (minutes < 60) {
    const rest = whole % 60;
    return rest && minutes < 10
      ? `${minutes}\u00a0min ${String(rest).padStart(2, "0")}\u00a0s`
      : `${minutes}\u00a0min`;
  }
  const hours = Math.floor(minutes / 60);
  return `${hours.toLocaleString(language)}\u00a0h ${String(minutes % 60).padStart(2, "0")}\u00a0min`;
}

function capital(text: string, wanted: boolean): string {
  return wanted ? text.charAt(0).toUpperCase() + text.slice(1) : text;
}
