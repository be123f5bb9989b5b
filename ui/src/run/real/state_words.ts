import { type Language, language, texts } from "../../i18n";
import { decimal } from "../../i18n/format";
import type { RobotState } from "./robot_state";

export interface StateWords {
  /** What is shown: changes with each second and each percent. */
  short: string;
  /** What is read out: changes only when something has happened. */
  spoken: string;
  /** What to do. */
  tip: string;
}

/** What is missing by its technical name, which is told to the teacher. */
const MISSING = new Set([
  "robot_not_found",
  "robot_elsewhere",
  "robot_wrong_type",
  "odometry_not_found",
  "odometry_elsewhere",
  "robot_silent",
]);

/** How a robot is, in words; one of which nothing is known yet is looked for. */
export function stateWords(state: RobotState | undefined): StateWords {
  const { state: say } = texts.value.robot;
  const { value: inLanguage } = language;
  const isMissing = MISSING.has(state?.code ?? "");
  const tip = (!isMissing && state?.remedy) || say.tips[state?.state ?? "searching"];
  switch (state?.state) {
    case "waiting": {
      const words = say.waiting(state.address);
      return { short: words, spoken: words, tip };
    }
    case "silent":
      return { short: say.silent(whole(state.age_s ?? 0, inLanguage)), spoken: say.lost, tip };
    case "connected": {
      const words = state.holder ? say.held(state.holder) : say.connected;
      const battery = state.battery === null ? [] : [batteryWords(state.battery, inLanguage)];
      return {
        short: [words, ...battery].join(" · "),
        spoken: words,
        tip: state.holder ? say.tips.held : tip,
      };
    }
    default: {
      const found = isMissing ? say.missing : state?.message;
      return { short: say.searching, spoken: found || say.searching, tip };
    }
  }
}

const batteryWords = (level: number, inLanguage: Language) =>
  texts.value.robot.state.battery(whole(level * 100, inLanguage));

const whole = (value: number, inLanguage: Language) => decimal(value, 0, inLanguage);
