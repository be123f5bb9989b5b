import { signal } from "@preact/signals";
import { remember, remembered } from "../app/remembered";

const COOKIE = "pinel_muted";

const FREQUENCY_HZ = 880;
const LENGTH_S = 0.16;
const LOUDNESS = 0.12;
/** From silence to tone and back, without a click. */
const FADE_S = 0.012;

export const muted = signal(remembered(COOKIE) === "1");

export function setMuted(value: boolean): void {
  muted.value = value;
  remember(COOKIE, value ? "1" : "0");
}

let context: AudioContext | null = null;
let quietFrom = 0;

/** A short tone. Silent until somebody has clicked in the page, as browsers demand; tones never pile up. */
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

/** Before the first click a browser would only complain. */
function mayPlay(): boolean {
  return "AudioContext" in window && navigator.userActivation?.hasBeenActive !== false;
}
