import { computed } from "@preact/signals";
import { choose, setting } from "../../shell/settings";

const chosen = setting("pinel_muted");
const loudness = setting("pinel_loudness");

const FREQUENCY_HZ = 880;
/** Tones one after the other, besides the beep: a rising chord for a solved mission, two notes up or down. */
const TONES_HZ = {
  start: [392, 523],
  arrival: [659, 784],
  collision: [196, 131],
  success: [523, 659, 784, 1047],
} as const;

export type SoundName = keyof typeof TONES_HZ;
const LENGTH_S = 0.16;
const LOUDNESS = { quiet: 0.03, normal: 0.12, loud: 0.4 } as const;
/** Duration of fade-in and fade-out, which avoid clicks. */
const FADE_S = 0.012;

/** Whether sound is off. */
export const muted = computed(() => chosen.value === "1");

export function setMuted(value: boolean): void {
  void choose("pinel_muted", value ? "1" : "0");
}

let context: AudioContext | null = null;
let quietFrom = 0;

/** Whether somebody has turned the sound on. All sounds need this but the beep, which only must not be muted. */
export const isSoundTurnedOn = computed(() => chosen.value === "0");

/** Plays a short tone. Before the first click in the page browsers forbid sound; tones do not overlap. */
export function beep(): void {
  if (muted.value) return;
  play([FREQUENCY_HZ]);
}

/** Plays a sound if somebody has turned the sound on. The fanfare waits for a sound that plays; others are left out. */
export function playSound(name: SoundName): void {
  if (isSoundTurnedOn.value) play(TONES_HZ[name], name === "success");
}

/** Plays tones one after the other. */
function play(frequencies: readonly number[], waits = false): void {
  if (document.hidden || !mayPlay()) return;
  context ??= new AudioContext();
  if (context.state === "suspended") void context.resume();
  if (context.currentTime < quietFrom && !waits) return;
  const begin = Math.max(context.currentTime, quietFrom);
  quietFrom = begin + LENGTH_S * frequencies.length;
  frequencies.forEach((frequency, index) => {
    if (context) tone(context, frequency, begin + LENGTH_S * index);
  });
}

function tone(audio: AudioContext, frequency: number, begin: number): void {
  const oscillator = new OscillatorNode(audio, { type: "triangle", frequency });
  const volume = new GainNode(audio, { gain: 0 });
  const gain = LOUDNESS[loudness.peek() || "normal"];
  volume.gain.setValueAtTime(0, begin);
  volume.gain.linearRampToValueAtTime(gain, begin + FADE_S);
  volume.gain.setValueAtTime(gain, begin + LENGTH_S - FADE_S);
  volume.gain.linearRampToValueAtTime(0, begin + LENGTH_S);
  oscillator.connect(volume).connect(audio.destination);
  oscillator.start(begin);
  oscillator.stop(begin + LENGTH_S);
}

/** Before the first click a browser would only log a warning. */
function mayPlay(): boolean {
  return "AudioContext" in window && navigator.userActivation?.hasBeenActive !== false;
}
