import { effect } from "@preact/signals";
import type { Language } from "../../api/model";
import { language } from "../../i18n";
import { spokenText } from "../values";
import { isSoundTurnedOn } from "./sound";

/** Longer texts are read to here. */
const MAX_LENGTH = 300;

/** Whether the system has a voice of its own for the language: one that sends nothing over a network. */
function voiceFor(spoken: Language): SpeechSynthesisVoice | null {
  const [short] = spoken.toLowerCase().split("-");
  const tagOf = ({ lang }: SpeechSynthesisVoice) => lang.toLowerCase().replace("_", "-");
  const own = speechSynthesis
    .getVoices()
    .filter((voice) => voice.localService && tagOf(voice).split("-")[0] === short);
  return own.find((voice) => tagOf(voice) === spoken.toLowerCase()) ?? own[0] ?? null;
}

/**
 * Reads a text of the robot aloud, if somebody has turned the sound on and the system has a voice. The text stands on
 * the floor and in the dialogue too. Texts that come faster than the voice reads are left out.
 */
export function speak(text: string | number): void {
  if (!isSoundTurnedOn.value || document.hidden || !("speechSynthesis" in window)) return;
  const voice = voiceFor(language.peek());
  if (!voice || speechSynthesis.pending) return;
  const words = spokenText(text, language.peek()).slice(0, MAX_LENGTH);
  const utterance = new SpeechSynthesisUtterance(words);
  utterance.voice = voice;
  utterance.lang = voice.lang;
  speechSynthesis.speak(utterance);
}

/** Ends what is read: the run was stopped. */
export function endSpeech(): void {
  if ("speechSynthesis" in window) speechSynthesis.cancel();
}

effect(() => {
  if (!isSoundTurnedOn.value) endSpeech();
});
