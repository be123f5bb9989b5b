import type { TimelineEntry, VersionDifference } from "../../../api/model";
import { language, texts } from "../../../i18n";
import { duration } from "../../../i18n/format";
import { labelled } from "../../../i18n/phrases";
import { robotLabel } from "../../../run/real/RobotName";
import { SIMULATOR } from "../../../run/real/real_robot";
import { roundDuration, timeOfDay } from "../../time_format";
import { shortDay } from "../days";
import { outcomeOf } from "../model";
import { countTexts, differenceTexts } from "./difference_texts";

/** Index of a group's timeline events: numbers of runs, and the repairs between runs. */
export class TimelineIndex {
  private readonly numbers = new Map<string, number>();
  private readonly repairedBy = new Map<string, TimelineEntry>();

  /** `withDays`: whether the lesson lasted several days, so that times need their day. */
  constructor(
    readonly entries: readonly TimelineEntry[],
    readonly withDays = false,
  ) {
    for (const entry of entries) {
      if (entry.run_id) this.numbers.set(entry.run_id, this.numbers.size + 1);
      if (entry.repairs) this.repairedBy.set(entry.repairs, entry);
    }
  }

  /** Number of a run within its group, from 1. */
  numberOf(run: string | null): number {
    return this.numbers.get(run ?? "") ?? 0;
  }

  /** The run that repaired a failed run, if there is one. */
  repairOf(entry: TimelineEntry): TimelineEntry | null {
    return (entry.run_id && this.repairedBy.get(entry.run_id)) || null;
  }

  /** The event whose versions show the change: for a repaired run, the run that repaired it. */
  changeOf(entry: TimelineEntry): TimelineEntry | null {
    const changed = this.repairOf(entry) ?? entry;
    return changed.changes ? changed : null;
  }
}

/** Text of a timeline event. */
export interface TimelineEventText {
  readonly title: string;
  readonly lines: readonly string[];
}

/** `difference`: the difference between the versions of `book.changeOf(entry)`; null while unknown. */
export function textOf(
  entry: TimelineEntry,
  book: TimelineIndex,
  difference: VersionDifference | null,
): TimelineEventText {
  const isRun = entry.kind === "run";
  const changed = book.changeOf(entry);
  const changes = changed ? changeTexts(changed, difference).join("; ") : "";
  const begin = `${texts.value.review.line.between} `;
  return {
    title: isRun ? runTitle(entry, book) : editsTitle(entry),
    lines: [
      ...(isRun ? aboutRun(entry, book) : [facts(entry, book)]),
      changes && `${isRun ? begin + changes : capital(changes)}.`,
    ].filter(Boolean),
  };
}

/** Number and outcome of a run. */
export function runTitle(entry: TimelineEntry, book: TimelineIndex): string {
  const { line, outcomes } = texts.value.review;
  return labelled(line.run({ n: book.numberOf(entry.run_id) }), outcomes[outcomeOf(entry)]);
}

function editsTitle(entry: TimelineEntry): string {
  const { line } = texts.value.review;
  const took = entry.until ? (Date.parse(entry.until) - Date.parse(entry.at)) / 1000 : 0;
  const edits = line.edits({ count: entry.n_edits ?? 0 });
  return took >= 1
    ? `${edits} ${line.within({ time: roundDuration(took, language.value) })}`
    : edits;
}

function aboutRun(entry: TimelineEntry, book: TimelineIndex): string[] {
  const { line } = texts.value.review;
  const repair = book.repairOf(entry);
  return [
    entry.message ?? "",
    facts(entry, book),
    entry.repairs ? line.repairs({ n: book.numberOf(entry.repairs) }) : "",
    repair ? line.repairedBy({ n: book.numberOf(repair.run_id) }) : "",
  ];
}

/** Program, mission if it is none of the lesson's, time, and duration of the run. */
export function facts(entry: TimelineEntry, book: TimelineIndex): string {
  const time = texts.value.review.detail.at({ time: timeOfDay(entry.at, language.value) });
  const day = shortDay(Date.parse(entry.at) / 1000, language.value);
  return [
    entry.program_name,
    entry.other_mission && texts.value.review.line.otherMission({ title: entry.other_mission }),
    book.withDays ? `${day} ${time}` : time,
    entry.duration_s ? duration(entry.duration_s, language.value) : null,
    ...onRobot(entry),
  ]
    .filter(Boolean)
    .join(" · ");
}

/** For a run on a real robot: the robot's name, and whether the run was judged for its activity. */
function onRobot({ link, activity, passed, state }: TimelineEntry): string[] {
  if (!link || link === SIMULATOR) return [];
  const { inReview } = texts.value.robot;
  const isJudged = passed === null ? inReview.notJudged : inReview.judged;
  return [robotLabel(link), activity && state !== "running" ? isJudged : ""];
}

/** Changes before an event: block by block if `difference` is known, else the number of blocks. */
export function changeTexts(entry: TimelineEntry, difference: VersionDifference | null): string[] {
  const { review } = texts.value;
  if (difference && entry.since) return differenceTexts(difference, review, language.value);
  return entry.changes ? countTexts(entry.changes, review) : [];
}

const capital = (text: string) => text.charAt(0).toUpperCase() + text.slice(1);
