import type { CalibratedParameter, Calibration } from "../../../api/model";
import type { Language, Texts } from "../../../i18n";
import { decimal } from "../../../i18n/format";

type Labels = Texts["calibration"];

/** Smaller errors are not worth a sentence: of a wheel in parts, of a turn in degrees. */
const SMALL_PART = 0.001;
const SMALL_DEG = 0.3;

/** What a calibration found, in sentences for a teacher. */
export function findings(found: Calibration, labels: Labels, language: Language): string[] {
  const by = new Map(found.parameters.map((one) => [one.name, one]));
  const known = (name: string) => {
    const one = by.get(name);
    return one?.is_known ? one : null;
  };
  const [left, right] = [known("wheel_bias_left"), known("wheel_bias_right")];
  const track = known("track_m");
  const delay = [known("latency_s"), known("lag_s")];
  return [
    left && right && wheelsText(right.value - left.value, labels, language),
    left && right && distanceText((left.value + right.value) / 2, labels, language),
    track && turnText(track, labels, language),
    delay[0] &&
      delay[1] &&
      labels.delay({ s: decimal(delay[0].value + delay[1].value, 2, language) }),
  ].filter((one): one is string => !!one);
}

/** Names of the parameters that the runs cannot tell. */
export function unknowns(found: Calibration, labels: Labels): string[] {
  return found.parameters
    .filter((one) => !one.is_known)
    .map((one) => labels.parameters[one.name as keyof Labels["parameters"]] ?? one.name);
}

/** How far off the prediction of a run by the others is, on average, in cm; null without such predictions. */
export function heldOutText(
  { held_out: held }: Calibration,
  labels: Labels,
  language: Language,
): string | null {
  if (held.length === 0) return null;
  const cm = (name: "error_m" | "expected_m" | "nominal_m") =>
    decimal(
      Math.sqrt(held.reduce((sum, one) => sum + one[name] ** 2, 0) / held.length) * 100,
      1,
      language,
    );
  return labels.heldOut({
    error: cm("error_m"),
    expected: cm("expected_m"),
    nominal: cm("nominal_m"),
  });
}

/** UMBmark's figure before the calibration, and what is left of it. */
export function squaresText(
  { n_left: left, n_right: right, worst_m, left_over_m }: NonNullable<Calibration["squares"]>,
  labels: Labels,
  language: Language,
): string {
  const before = decimal(worst_m * 100, 1, language);
  if (left_over_m === null) return labels.squaresAlone({ left, right, before });
  return labels.squares({ left, right, before, after: decimal(left_over_m * 100, 1, language) });
}

/** A parameter with its interval: in the unit and with the digits that suit it. */
export function interval(one: CalibratedParameter, labels: Labels, language: Language): string {
  const shown = (value: number) =>
    one.name.startsWith("wheel")
      ? `${decimal(value * 100, 1, language)} %`
      : `${decimal(value, 3, language)} ${one.name.endsWith("_m") ? "m" : "s"}`;
  const [value, nominal] = [shown(one.value), shown(one.nominal)];
  if (one.low === one.high) return labels.value({ value, nominal });
  return labels.interval({ value, low: shown(one.low), high: shown(one.high), nominal });
}

function wheelsText(difference: number, labels: Labels, language: Language): string {
  if (Math.abs(difference) < SMALL_PART) return labels.wheelsEqual;
  const percent = decimal(Math.abs(difference) * 100, 1, language);
  return difference > 0 ? labels.rightLarger({ percent }) : labels.leftLarger({ percent });
}

function distanceText(bias: number, labels: Labels, language: Language): string | null {
  if (Math.abs(bias) < SMALL_PART) return null;
  const cm = decimal(Math.abs(bias) * 100, 1, language);
  return bias > 0 ? labels.fartherPerMetre({ cm }) : labels.shorterPerMetre({ cm });
}

function turnText(track: CalibratedParameter, labels: Labels, language: Language): string {
  const excess = 360 * (track.nominal / track.value - 1);
  if (Math.abs(excess) < SMALL_DEG) return labels.turnsRight;
  const angle = decimal(Math.abs(excess), 1, language);
  return excess > 0 ? labels.turnsMore({ angle }) : labels.turnsLess({ angle });
}
