import { expect, test, vi } from "vitest";
import { choose } from "../../shell/settings";
import { beep, playSound } from "./sound";

const gains: number[] = [];
let now = 0;

/** The part of Web Audio that a tone needs; records the loudness of each tone. */
class FakeNode {
  readonly gain = {
    setValueAtTime: () => {},
    linearRampToValueAtTime: (gain: number) => void (gain > 0 && gains.push(gain)),
  };
  readonly connect = (next: unknown) => next;
  start() {}
  stop() {}
}

vi.stubGlobal("fetch", async () => new Response("{}"));
vi.stubGlobal("OscillatorNode", FakeNode);
vi.stubGlobal("GainNode", FakeNode);
vi.stubGlobal(
  "AudioContext",
  class {
    readonly state = "running";
    get currentTime() {
      now += 1;
      return now;
    }
  },
);

test("a beep is as loud as this PC is to be, and a group can turn it off", () => {
  beep();
  void choose("pinel_loudness", "quiet");
  beep();
  void choose("pinel_loudness", "loud");
  beep();
  const [normal = 0, quiet = 0, loud = 0] = gains;
  expect(quiet).toBeLessThan(normal);
  expect(normal).toBeLessThan(loud);
  void choose("pinel_muted", "1");
  beep();
  expect(gains).toHaveLength(3);
});

test("sounds of a run are silent until somebody has turned the sound on; the fanfare waits for its turn", () => {
  const before = gains.length;
  void choose("pinel_muted", "");
  for (const name of ["start", "arrival", "collision", "success"] as const) playSound(name);
  expect(gains).toHaveLength(before);
  void choose("pinel_muted", "0");
  now += 10;
  playSound("arrival");
  playSound("success");
  expect(gains).toHaveLength(before + 6);
});
