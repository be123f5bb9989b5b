import type { Language, Texts } from "../../i18n";
import { percent } from "../../i18n/format";
import type { CaptureAnswer } from "../reducer";

/** Describes the answer to a capture: the sign, and its source, such as the camera or a person. */
export function captureText(given: CaptureAnswer, { status }: Texts, language: Language): string {
  const captured = given.what === "number" ? status.capturedNumber : status.captured;
  const { label, by, confidence } = given;
  if (by === null) return captured.noneSeen;
  if (by === "person") return label ? captured.person({ sign: label }) : captured.personNone;
  if (label === "") return captured.noneSeen;
  if (by === "list") return captured.list({ sign: label });
  return captured[by]({ sign: label, sure: percent(confidence ?? 0, language) });
}
