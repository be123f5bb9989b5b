import { type Language, language, texts } from "../../i18n";
import { decimal } from "../../i18n/format";
import type { RobotState } from "./robot_state";

export interface StateText {
  /** The text on the screen: changes with each second and each percent. */
  short: string;
  /** The text for screen readers: changes only when the state has changed. */
  spoken: string;
  /** The advice. */
  tip: string;
}

/** Codes whose messages name topics and types; only the teacher's part shows such messages. */
const MISSING = new Set([
  "robot_not_found",
  "robot_elsewhere",
  "robot_wrong_type",
  "odometry_not_found",
  "odometry_elsewhere",
  "robot_silent",
]);

/** Describes the state of a robot; a robot without a state yet is being searched for. */
export function stateText(state: RobotState | undefined): StateText {
  const { state: labels } = texts.value.robot;
  const { value: inLanguage } = language;
  const isMissing = MISSING.has(state?.code ?? "");
  const tip = (!isMissing && state?.remedy) || labels.tips[state?.state ?? "searching"];
  switch (state?.state) {
    case "waiting": {
      const text = labels.waiting({ address: state.address });
      return { short: text, spoken: text, tip };
    }
    case "silent":
      return {
        short: labels.silent({ seconds: whole(state.age_s ?? 0, inLanguage) }),
        spoken: labels.lost,
        tip,
      };
    case "connected": {
      const text = state.holder ? labels.held({ name: state.holder }) : labels.connected;
      const battery = state.battery === null ? [] : [batteryText(state.battery, inLanguage)];
      return {
        short: [text, ...battery].join(" · "),
        spoken: text,
        tip: state.holder ? labels.tips.held : tip,
      };
    }
    default: {
      const found = isMissing ? labels.missing : state?.message;
      return { short: labels.searching, spoken: found || labels.searching, tip };
    }
  }
}

const batteryText = (level: number, inLanguage: Language) =>
  texts.value.robot.state.battery({ percent: whole(level * 100, inLanguage) });

const whole = (value: number, inLanguage: Language) => decimal(value, 0, inLanguage);
