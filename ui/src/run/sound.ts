import { signal } from "@preact/signals";
import { remember, remembered } from "../shell/remembered";

const COOKIE = "pinel_muted";

const FREQUENCY_HZ = 880;
const LENGTH_S = 0.16;
const LOUDNESS = 0.12;
/** Duration of fade-in and fade-out, which avoid clicks. */
const FADE_S = 0.012;

/** Whether sound is off, as stored in a cookie. */
export const muted = signal(remembered(COOKIE) === "1");

export function setMuted(value: boolean): void {
  muted.value = value;
  remember(COOKIE, value ? "1" : "0");
}

let context: AudioContext | null = null;
let quietFrom = 0;

/** Plays a short tone. Silent before the first click in the page, as browsers require; tones do not overlap. */
export function beep(): void {
  if (muted.value || document.hidden || !mayPlay()) return;
  context ??= new AudioContext();
  if (context.state === "suspended") void context.resume();
  const now = context.currentTime;
  if (now < quietFrom) return;
  quietFrom = now + LENGTH_S;
  const tone = new OscillatorNode(context, { type: "triangle", frequency: FREQUENCY_HZ });
  const volume = new GainNode(context, { gain: 0 });
  volume.gain.linearRampToValueAtTime(LOUDNESS, now + FADE_S);
  volume.gain.setValueAtTime(LOUDNESS, now + LENGTH_S - FADE_S);
  volume.gain.linearRampToValueAtTime(0, now + LENGTH_S);
  tone.connect(volume).connect(context.destination);
  tone.start(now);
  tone.stop(now + LENGTH_S);
}

/** Before the first click a browser would only log a warning. */
function mayPlay(): boolean {
  return "AudioContext" in window && navigator.userActivation?.hasBeenActive !== false;
}
