import type { ReviewMark, VersionDifference } from "../../../api/model";
import { language, texts } from "../../../i18n";
import { duration } from "../../../i18n/format";
import { robotLabel } from "../../../run/real/RobotName";
import { SIMULATOR } from "../../../run/real/real_robot";
import { roundDuration, timeOfDay } from "../../time_format";
import { shortDay } from "../days";
import { outcomeOf } from "../model";
import { countTexts, differenceTexts } from "./difference_texts";

/** Index of a group's timeline events: numbers of runs, and the repairs between runs. */
export class TimelineIndex {
  private readonly numbers = new Map<string, number>();
  private readonly repairedBy = new Map<string, ReviewMark>();

  /** `withDays`: whether the lesson lasted several days, so that times need their day. */
  constructor(
    readonly marks: readonly ReviewMark[],
    readonly withDays = false,
  ) {
    for (const mark of marks) {
      if (mark.run_id) this.numbers.set(mark.run_id, this.numbers.size + 1);
      if (mark.repairs) this.repairedBy.set(mark.repairs, mark);
    }
  }

  /** Number of a run within its group, from 1. */
  numberOf(run: string | null): number {
    return this.numbers.get(run ?? "") ?? 0;
  }

  /** The run that repaired a failed run, if there is one. */
  repairOf(mark: ReviewMark): ReviewMark | null {
    return (mark.run_id && this.repairedBy.get(mark.run_id)) || null;
  }

  /** The event whose versions show the change: for a repaired run, the run that repaired it. */
  changeOf(mark: ReviewMark): ReviewMark | null {
    const changed = this.repairOf(mark) ?? mark;
    return changed.changes ? changed : null;
  }
}

/** Text of a timeline event. */
export interface TimelineEventText {
  readonly title: string;
  readonly lines: readonly string[];
}

/** `difference`: the difference between the versions of `book.changeOf(mark)`; null while unknown. */
export function textOf(
  mark: ReviewMark,
  book: TimelineIndex,
  difference: VersionDifference | null,
): TimelineEventText {
  const isRun = mark.kind === "run";
  const changed = book.changeOf(mark);
  const changes = changed ? changeTexts(changed, difference).join("; ") : "";
  const begin = `${texts.value.review.line.between} `;
  return {
    title: isRun ? runTitle(mark, book) : editsTitle(mark),
    lines: [
      ...(isRun ? aboutRun(mark, book) : [facts(mark, book)]),
      changes && `${isRun ? begin + changes : capital(changes)}.`,
    ].filter(Boolean),
  };
}

/** Number and outcome of a run. */
export function runTitle(mark: ReviewMark, book: TimelineIndex): string {
  const { line, outcomes } = texts.value.review;
  return `${line.run({ n: book.numberOf(mark.run_id) })}: ${outcomes[outcomeOf(mark)]}`;
}

function editsTitle(mark: ReviewMark): string {
  const { line } = texts.value.review;
  const took = mark.until ? (Date.parse(mark.until) - Date.parse(mark.at)) / 1000 : 0;
  const edits = line.edits({ count: mark.n_edits ?? 0 });
  return took >= 1
    ? `${edits} ${line.within({ time: roundDuration(took, language.value) })}`
    : edits;
}

function aboutRun(mark: ReviewMark, book: TimelineIndex): string[] {
  const { line } = texts.value.review;
  const repair = book.repairOf(mark);
  return [
    mark.message ?? "",
    facts(mark, book),
    mark.repairs ? line.repairs({ n: book.numberOf(mark.repairs) }) : "",
    repair ? line.repairedBy({ n: book.numberOf(repair.run_id) }) : "",
  ];
}

/** Program, time, and duration of the run. */
export function facts(mark: ReviewMark, book: TimelineIndex): string {
  const time = texts.value.review.detail.at({ time: timeOfDay(mark.at, language.value) });
  const day = shortDay(Date.parse(mark.at) / 1000, language.value);
  return [
    mark.program_name,
    book.withDays ? `${day} ${time}` : time,
    mark.duration_s ? duration(mark.duration_s, language.value) : null,
    ...onRobot(mark),
  ]
    .filter(Boolean)
    .join(" · ");
}

/** For a run on a real robot: the robot's name, and whether the run was judged for its activity. */
function onRobot({ link, activity, passed, state }: ReviewMark): string[] {
  if (!link || link === SIMULATOR) return [];
  const { inReview } = texts.value.robot;
  const isJudged = passed === null ? inReview.notJudged : inReview.judged;
  return [robotLabel(link), activity && state !== "running" ? isJudged : ""];
}

/** Changes before an event: block by block if `difference` is known, else the number of blocks. */
export function changeTexts(mark: ReviewMark, difference: VersionDifference | null): string[] {
  const { review } = texts.value;
  if (difference && mark.since) return differenceTexts(difference, review, language.value);
  return mark.changes ? countTexts(mark.changes, review) : [];
}

const capital = (text: string) => text.charAt(0).toUpperCase() + text.slice(1);
