import type { Sentence } from "../sentence";
import { activeRealLink } from "./real_robot";
import { robotStates } from "./robot_state";
import { stateText } from "./state_text";

/** Why the chosen robot cannot drive, and the remedy; null if it is connected or none is chosen. */
export function robotSentence(): Sentence | null {
  const { value: link } = activeRealLink;
  const state = link === null ? undefined : robotStates.value[link];
  if (!state || (state.state === "connected" && !state.holder)) return null;
  const { spoken, tip } = stateText(state);
  const isTrouble = state.code !== null || state.holder !== null || state.state === "silent";
  return { text: spoken, detail: tip, tone: isTrouble ? "notice" : "calm" };
}
