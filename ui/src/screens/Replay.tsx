import { useComputed, useSignal } from "@preact/signals";
import { ArrowLeft, ChartLine, Eye } from "lucide-preact";
import { useEffect, useRef } from "preact/hooks";
import { TEST } from "../app/testids";
import { theme } from "../app/theme";
import { createEditor, type Editor } from "../editor";
import { language, texts } from "../i18n";
import { MuteButton } from "../run/MuteButton";
import type { Playback } from "../run/playback";
import { Readout } from "../run/Readout";
import { litBlock } from "../run/reducer";
import { Shown } from "../run/Shown";
import { StatusLine } from "../run/StatusLine";
import { parameterIn, type Sentence, sentenceOf } from "../run/sentence";
import { beep } from "../run/sound";
import { Scene } from "../scene/Scene";
import { FootButton } from "./FootButton";
import { later } from "./later";
import type { Recording } from "./ReplayScreen";
import { Transport } from "./Transport";
import "../run/run.css";

const PlotsPanel = later(async () => (await import("../plots/PlotsPanel")).PlotsPanel);

interface ReplayProps {
  recording: Recording;
  onOpen(): void;
}

/** Floor, blocks and time of a run that was. */
export function Replay({ recording, onOpen }: ReplayProps) {
  const { run, playback } = recording;
  const { replay, plots } = texts.value;
  const plotting = useSignal(false);
  const tall = useSignal(false);
  const besides = plotting.value ? "floor__view--beside" : "";
  useEffect(() => soundOf(playback), [playback]);
  return (
    <main class="screen replay">
      <h1 class="visually-hidden">{replay.title}</h1>
      <section class="blocks" aria-label={replay.ofVersion}>
        <div class="blocks__tools replay__tools">
          <Eye class="icon" aria-hidden="true" />
          <p>{run.version ? replay.readOnly : replay.noVersion}</p>
          {run.program_id && (
            <button type="button" class="button" data-testid={TEST.replayProgram} onClick={onOpen}>
              <ArrowLeft class="icon" aria-hidden="true" />
              {replay.openProgram}
            </button>
          )}
        </div>
        <ReadOnlyBlocks recording={recording} />
      </section>
      <section class="floor" aria-label={texts.value.studio.floor}>
        <Words recording={recording} />
        <div class="floor__stage">
          <div class={`floor__view ${besides}`} hidden={plotting.value && tall.value}>
            <div class="floor__scene">
              <Scene world={run.world_document} view={playback.view} poseAt={playback.pose} />
              <div class="floor__corner">
                <MuteButton view={playback.view} />
              </div>
            </div>
            <Shown view={playback.view} />
          </div>
          {plotting.value && (
            <div
              class={`floor__drawer floor__drawer--plots ${tall.value ? "floor__drawer--tall" : ""}`}
            >
              <PlotsPanel
                source={recording.plots}
                tall={tall.value}
                onTall={(wanted) => {
                  tall.value = wanted;
                }}
              />
            </div>
          )}
        </div>
        <div class="floor__foot card">
          <Readout view={playback.view} />
          <FootButton
            testId={TEST.plotsToggle}
            Icon={ChartLine}
            word={plots.open}
            label={plots.label}
            open={plotting.value}
            onClick={() => {
              plotting.value = !plotting.value;
            }}
          />
        </div>
      </section>
      <Transport recording={recording} />
    </main>
  );
}

/** Faster than this a beep is noise. */
const LOUD_SPEED = 2;

function soundOf(playback: Playback): () => void {
  let heard = playback.view.value.output.beeps;
  return playback.view.subscribe(({ output: { beeps } }) => {
    const { playing, speed } = playback;
    if (beeps > heard && playing.peek() && speed.peek() <= LOUD_SPEED) beep();
    heard = beeps;
  });
}

function Words({ recording: { run, playback } }: { recording: Recording }) {
  const sentence = useComputed<Sentence>(() => {
    const begin: Sentence = { text: texts.value.replay.begin, more: "", tone: "calm" };
    if (playback.tick.value < 1) return begin;
    const voice = {
      texts: texts.value,
      language: language.value,
      parameterOf: (pointer: string, name: string) =>
        parameterIn(run.version?.document, pointer, name),
    };
    return sentenceOf(playback.view.value, voice) ?? begin;
  });
  return <StatusLine sentence={sentence.value} />;
}

function ReadOnlyBlocks({ recording: { run, playback } }: { recording: Recording }) {
  const container = useRef<HTMLDivElement>(null);
  const editor = useRef<Editor | null>(null);

  useEffect(() => {
    if (!container.current || !run.version) return;
    const made = createEditor({
      container: container.current,
      language: language.value,
      theme: theme.value,
      mediaPath: "/media/",
      onChange: () => {},
    });
    editor.current = made;
    made.load(run.version.workspace);
    made.setReadOnly(true);
    const stop = playback.view.subscribe((view) => made.highlight(litBlock(view)));
    return () => {
      stop();
      made.dispose();
      editor.current = null;
    };
  }, [run.id]);

  useEffect(() => editor.current?.setTheme(theme.value), [theme.value]);
  useEffect(() => editor.current?.setLanguage(language.value), [language.value]);

  return <div class="blocks__editor" ref={container} data-testid={TEST.editor} />;
}
