import type { Sticker } from "../api/model";

/** Chapters of the album: the paths of the activities screen, then what groups did in their own way. */
export const CHAPTERS = [
  "moves",
  "shapes",
  "decisions",
  "sensors",
  "games",
  "own",
  "character",
] as const;
export type ChapterName = (typeof CHAPTERS)[number];

export interface Chapter {
  readonly name: ChapterName;
  readonly stickers: readonly Sticker[];
}

/** The chapters of an album, without empty ones. */
export function chaptersOf(stickers: readonly Sticker[]): Chapter[] {
  return CHAPTERS.map((name) => ({
    name,
    stickers: stickers.filter((one) => chapterOf(one) === name),
  })).filter((chapter) => chapter.stickers.length > 0);
}

/** Activities of a newer release may have a path that this one lacks. */
const chapterOf = ({ kind, path }: Sticker): ChapterName =>
  kind === "character" ? kind : (CHAPTERS.find((one) => one === path) ?? "own");

/** On paper, more activities of teachers than these have no empty places. */
const MAX_OWN_ON_PAPER = 14;

/** The stickers of a chapter that are printed. */
export function onPaper({ name, stickers }: Chapter): readonly Sticker[] {
  const isLong = name === "own" && stickers.length > MAX_OWN_ON_PAPER;
  return isLong ? stickers.filter(({ win }) => win) : stickers;
}

/** A4 inside its margins, without the head of the page. */
const PAGE_MM = { width: 190, height: 256 };
const TITLE_MM = 7;
const NAME_MM = 7;
const NOTE_MM = 9;
const GAP_MM = 2;
const COLUMNS = [7, 8, 9, 10, 11, 12] as const;
const MIN_WITH_NOTE_MM = 16;
const MIN_MM = 4;

/** How the places stand on one page of paper. */
export interface PrintLayout {
  readonly columns: number;
  /** Side of a sticker, in mm. */
  readonly side: number;
  /** Whether a sentence fits below each name. */
  readonly withNotes: boolean;
}

/** The layout with the largest stickers with which all chapters fit on one page; `sizes` are the numbers of stickers. */
export function printLayout(sizes: readonly number[]): PrintLayout {
  const layouts = COLUMNS.map((columns): PrintLayout => {
    const nRows = sizes.reduce((sum, size) => sum + Math.ceil(size / columns), 0);
    const row = (PAGE_MM.height - sizes.length * TITLE_MM) / Math.max(1, nRows) - GAP_MM;
    const width = PAGE_MM.width / columns - GAP_MM;
    const withNotes = Math.min(width, row - NAME_MM - NOTE_MM) >= MIN_WITH_NOTE_MM;
    const side = Math.min(width, row - NAME_MM - (withNotes ? NOTE_MM : 0));
    return { columns, side: Math.max(MIN_MM, side), withNotes };
  });
  return layouts.find(({ withNotes }) => withNotes) ?? layouts.reduce(larger);
}

const larger = (one: PrintLayout, other: PrintLayout) => (other.side > one.side ? other : one);
