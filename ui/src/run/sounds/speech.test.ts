import { beforeEach, expect, test, vi } from "vitest";
import { choose } from "../../shell/settings";

interface Voice {
  lang: string;
  localService: boolean;
}

const spoken: { text: string; lang: string }[] = [];
let voices: Voice[] = [];
let pending = false;
const cancel = vi.fn();

vi.stubGlobal("fetch", async () => new Response("{}"));
vi.stubGlobal("speechSynthesis", {
  getVoices: () => voices,
  speak: (one: { text: string; lang: string }) => void spoken.push(one),
  cancel,
  get pending() {
    return pending;
  },
});
vi.stubGlobal(
  "SpeechSynthesisUtterance",
  class {
    lang = "";
    voice: Voice | null = null;
    constructor(readonly text: string) {}
  },
);
const { speak } = await import("./speech");

beforeEach(() => {
  spoken.length = 0;
  pending = false;
  voices = [{ lang: "pt_BR", localService: true }];
  void choose("pinel_muted", "0");
});

test("a text is read by a voice of this PC in the page's language, numbers as the page writes them", () => {
  voices = [
    { lang: "en-US", localService: true },
    { lang: "pt-PT", localService: true },
    { lang: "pt-BR", localService: true },
  ];
  speak("Oi");
  speak(0.25);
  expect(spoken.map(({ text, lang }) => [text, lang])).toEqual([
    ["Oi", "pt-BR"],
    ["0,25", "pt-BR"],
  ]);
});

test("no voice of a network, and none of another language, ever reads", () => {
  voices = [
    { lang: "pt-BR", localService: false },
    { lang: "en-US", localService: true },
  ];
  speak("Oi");
  voices = [];
  speak("Oi");
  expect(spoken).toEqual([]);
});

test("nothing is read until somebody has turned the sound on, and turning it off ends it", () => {
  void choose("pinel_muted", "");
  speak("Oi");
  expect(spoken).toEqual([]);
  void choose("pinel_muted", "0");
  speak("Oi");
  expect(spoken).toHaveLength(1);
  cancel.mockClear();
  void choose("pinel_muted", "1");
  expect(cancel).toHaveBeenCalled();
  speak("Oi");
  expect(spoken).toHaveLength(1);
});

test("texts that come faster than the voice are left out", () => {
  pending = true;
  speak("Oi");
  expect(spoken).toEqual([]);
});
