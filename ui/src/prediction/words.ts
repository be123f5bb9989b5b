import type { Finding, RunPrediction, StepDifference, UnusualRun } from "../api/model";
import type { Language, Texts } from "../i18n";
import { decimal, formatNumber } from "../i18n/format";

type Kind = "turn" | "move";
interface Voice {
  readonly texts: Texts;
  readonly language: Language;
}

/** An angle to a tenth of a degree. */
export const angle = (degrees: number, language: Language) => `${decimal(degrees, 1, language)}°`;

/** A distance in centimetres, from a metre on in metres. */
export const length = (metres: number, language: Language) =>
  Math.abs(metres) < 0.995
    ? `${decimal(100 * metres, 1, language)}\u00a0cm`
    : `${decimal(metres, 2, language)}\u00a0m`;

/** How much, without a sign. */
const size = (kind: UnusualRun["kind"], value: number, language: Language) =>
  kind === "turn" ? angle(Math.abs(value), language) : length(Math.abs(value), language);

type Command = Pick<StepDifference, "action" | "amount">;

/** A command as its block says it. */
export function commandText({ action, amount }: Command, { texts, language }: Voice): string {
  const { commands } = texts.prediction;
  const by = formatNumber(Math.abs(amount ?? 0), language);
  if (action === "move_forward" || action === "move_backward" || action === "turn")
    return commands[action]({ by });
  if (action === "arc" || action === "wait") return commands[action]({ by });
  return commands.other;
}

/** "O robô girou 3,1° a menos": the beginning of a sentence about a difference. */
function deviation(kind: Kind, value: number, { texts, language }: Voice): string {
  const { turnLess, turnMore, moveLess, moveMore } = texts.prediction;
  const by = size(kind, value, language);
  if (kind === "turn") return value < 0 ? turnLess({ by }) : turnMore({ by });
  return value < 0 ? moveLess({ by }) : moveMore({ by });
}

function findingText(finding: Finding, voice: Voice): string {
  const { prediction: words } = voice.texts;
  const command = commandText(finding, voice);
  const what = deviation(finding.kind, finding.difference, voice);
  const where = {
    each: words.each({ command, n: finding.n }),
    once: words.once({ command }),
    average: finding.block === null ? words.averageTurn : words.average({ command }),
  }[finding.how];
  return words.finding({ what, where, source: words.sources[finding.source] });
}

/** What is most worth a sentence about a run beside its prediction. */
export function predictionText({ difference }: RunPrediction, voice: Voice): string {
  const { prediction: words } = voice.texts;
  const [first] = difference.findings;
  if (first) return findingText(first, voice);
  if (difference.steps.length === 0) return words.nothing;
  return words.fits({ source: words.sources[difference.source] });
}

/** Which calibrated robot predicts, how surely, and whether the run agrees; null for the ideal robot. */
export function robotText(prediction: RunPrediction, { texts, language }: Voice): string | null {
  const { robot, within_m: within, difference } = prediction;
  const { prediction: words } = texts;
  if (robot === null) return null;
  if (within === null) return words.robot({ robot });
  const stated = length(within, language);
  const end = difference.is_whole ? difference.at_end : null;
  if (!end || end.source === "odometry") return words.robotWithin({ robot, within: stated });
  const distance = length(end.distance_m, language);
  const source = words.sources[end.source];
  const say = end.distance_m <= within ? words.robotInside : words.robotOutside;
  return say({ robot, distance, source, within: stated });
}

/** What limits the comparison. */
export function notesOf(prediction: RunPrediction, { texts }: Voice): string[] {
  const { prediction: words } = texts;
  const { difference } = prediction;
  return [
    words.sourceHints[difference.source],
    prediction.robot !== null &&
      difference.source === "odometry" &&
      words.robotPath({ robot: prediction.robot }),
    difference.parted !== null && words.parted,
    prediction.awaits_input && words.noInput,
    prediction.is_cut && words.cut,
    prediction.reads_sensors && words.sensors,
    !prediction.knows_room && words.noRoom,
  ].filter((note): note is string => Boolean(note));
}

/** What is out of the ordinary in a run, and what is usual for its robot. */
export function unusualText(run: UnusualRun, voice: Voice): { text: string; usual: string } {
  const { prediction: words } = voice.texts;
  const { kind, difference, action, amount, n_runs: n } = run;
  const source = words.sources[run.source];
  if (kind === "path" || action === null) {
    const by = size("path", difference, voice.language);
    const usual = words.usual({ n, usual: size("path", run.usual, voice.language) });
    return { text: words.unusualPath({ by, source }), usual };
  }
  const command = commandText({ action, amount }, voice);
  const what = deviation(kind, difference, voice);
  const usual = deviation(kind, run.usual, voice);
  const text = words.unusual({ what, where: words.once({ command }), source });
  return { text, usual: words.usual({ n, usual }) };
}
