import type { BelievedPose, Language, Truth, TruthList } from "../api/model";
import type { Texts } from "../i18n";
import { degrees, duration, headingDegrees, metres } from "../i18n/format";
import type { FollowedRun } from "../run/real/truth_sources";

type Place = BelievedPose;

/** What a source says about the end of a run, and what the robot believed: each a sentence, the source named. */
export function truthSentences(list: TruthList, of: Texts, language: Language) {
  return list.truths.map((truth) => ({
    source: truth.source,
    text: [
      sentence(truth, of, language),
      difference(truth, list.believed, of, language),
      coverage(truth, list.run_s, of, language),
    ]
      .filter(Boolean)
      .join(" "),
  }));
}

/** For how long of the run a camera or a localisation knew the place; "" for a tape measure. */
function coverage(
  { source, covered_s }: Truth,
  run_s: number,
  { truth: words }: Texts,
  language: Language,
): string {
  if (source === "tape") return "";
  const [seen, whole] = [Math.min(covered_s, run_s), run_s].map((one) => duration(one, language));
  return words.covered[source]({ seen: seen ?? "", whole: whole ?? "" });
}

/** What went wrong with each source that followed the robot in a run that is over. */
export function followedSentences(
  sources: readonly (FollowedRun & { readonly source: Truth["source"] })[],
  { truth: words }: Texts,
): string[] {
  return sources.flatMap(({ source, state, problems }) => [
    ...(state === "nothing" && source !== "tape" ? [words.nothing[source]] : []),
    ...(problems.length > 0 ? [words.during({ problems: problems.join(" ") })] : []),
  ]);
}

function sentence(truth: Truth, { truth: words }: Texts, language: Language): string {
  const end = truth.poses.at(-1);
  const place = end ? placeText(end, words, language) : "";
  return words.sentence({ source: words.sources[truth.source], place });
}

function difference(
  { poses }: Truth,
  believed: Place | null,
  { truth: words }: Texts,
  language: Language,
): string {
  const end = poses.at(-1);
  if (!believed || !end) return "";
  const distance = Math.hypot(end.x_m - believed.x_m, end.y_m - believed.y_m);
  return words.believed({
    place: placeText(believed, words, language),
    distance: lengthText(distance, language),
  });
}

/** A pose as a person measures it from the start mark: "1,02 m à frente, 3 cm à esquerda, virado 12° para a direita". */
export function placeText(pose: Place, words: Texts["truth"], language: Language): string {
  const sides = [
    sideText(pose.x_m, words.ahead, words.behind, language),
    sideText(pose.y_m, words.left, words.right, language),
  ].filter(Boolean);
  const place = sides.length > 0 ? sides.join(", ") : words.atStart;
  return `${place}, ${headingText(pose.heading_rad, words, language)}`;
}

function sideText(value: number, positive: string, negative: string, language: Language): string {
  if (Math.abs(value) < 0.005) return "";
  return `${lengthText(Math.abs(value), language)} ${value > 0 ? positive : negative}`;
}

function lengthText(value: number, language: Language): string {
  const cm = Math.round(value * 100);
  return cm < 100 ? `${cm}\u00a0cm` : metres(value, language);
}

function headingText(heading: number, words: Texts["truth"], language: Language): string {
  const turn = Math.round(headingDegrees(heading));
  if (turn === 0) return words.headingStraight;
  const angle = degrees(Math.abs(turn), language);
  return turn > 0 ? words.headingLeft({ angle }) : words.headingRight({ angle });
}
