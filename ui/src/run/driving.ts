import type { Language, Texts } from "../i18n";
import { degrees, metres } from "../i18n/format";
import { type Speed, STANDSTILL_MPS, STANDSTILL_RADPS } from "./reducer";

/** Describes the robot's motion while no motion command is active; null while it is at rest. */
export function drivingText(speed: Speed, texts: Texts, language: Language): string | null {
  const { status } = texts;
  const { linear, angular } = speed;
  const rolls = Math.abs(linear) > STANDSTILL_MPS;
  const turns = Math.abs(angular) > STANDSTILL_RADPS;
  const pace = `${metres(Math.abs(linear), language)}/s`;
  if (rolls && turns) return angular > 0 ? status.driveLeft({ pace }) : status.driveRight({ pace });
  if (rolls) return linear > 0 ? status.drive({ pace }) : status.driveBack({ pace });
  if (!turns) return null;
  const spin = `${degrees((Math.abs(angular) * 180) / Math.PI, language)}/s`;
  return angular > 0 ? status.spinLeft({ pace: spin }) : status.spinRight({ pace: spin });
}
