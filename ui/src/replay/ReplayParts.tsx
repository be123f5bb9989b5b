import type { ReadonlySignal } from "@preact/signals";
import { effect, useComputed } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import type { JudgedEvent, RunWithVersion } from "../api/model";
import { createEditor, type Editor, type Fault } from "../editor";
import { language, type Texts, texts } from "../i18n";
import { besideBlock, failureIn } from "../run/failure";
import { withVerdict } from "../run/judgement";
import { StatusLine } from "../run/panels/StatusLine";
import { activeBlockId, isLive, type RunView } from "../run/reducer";
import { parameterIn, type Sentence, sentenceOf } from "../run/sentence";
import { theme } from "../shell/theme";
import type { Predicted } from "./predicted";

/** A recorded run and its state at the current tick. */
export interface ReplayedRun {
  readonly run: RunWithVersion;
  readonly view: ReadonlySignal<RunView>;
}

/** The verdict on a recorded run, as the studio got it at its end; null if the record does not say what was lacking. */
function judgedOf(run: RunWithVersion): JudgedEvent | null {
  const { id, passed, missing, missing_block, by_robot, not_judged } = run;
  if (!passed && !missing && !not_judged) return null;
  return {
    type: "judged",
    run: id,
    passed,
    missing,
    block: missing_block,
    cases: [],
    by_robot,
    not_judged,
  };
}

/** What the run lacks, at its block, at the end of the run. */
function adviceAt({ missing, missing_block }: RunWithVersion, view: RunView): Fault[] {
  if (!missing || !missing_block || isLive(view)) return [];
  return [{ block: missing_block, message: missing, remedy: "", isQuiet: true }];
}

interface ReplaySentenceProps extends ReplayedRun {
  /** The sentence before the first tick. */
  beginning(all: Texts): string;
}

/** A sentence about the robot's action at the current tick. */
export function ReplaySentence({ run, view, beginning }: ReplaySentenceProps) {
  const sentence = useComputed<Sentence>(() => {
    const begin: Sentence = { text: beginning(texts.value), detail: "", tone: "calm" };
    // a run that was interrupted before its first tick has only an ending to show
    if (view.value.tick < 1 && isLive(view.value)) return begin;
    const voice = {
      texts: texts.value,
      language: language.value,
      parameterOf: (pointer: string, name: string) =>
        parameterIn(run.version?.document, pointer, name),
      past: true,
      program: run.version,
    };
    const now = sentenceOf(view.value, voice) ?? begin;
    if (isLive(view.value)) return now;
    const ended = withVerdict(now, run.id, judgedOf(run), texts.value);
    return besideBlock(ended, failureIn(view.value, language.value));
  });
  return <StatusLine sentence={sentence.value} />;
}

interface ReplayBlocksProps extends ReplayedRun {
  predicted?: Predicted;
}

/**
 * The blocks of the recorded version, with the running block highlighted and the failed one
 * outlined.
 */
export function ReplayBlocks({ run, view, predicted }: ReplayBlocksProps) {
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
    const stop = effect(() => {
      made.highlight(activeBlockId(view.value));
      const lacking = adviceAt(run, view.value);
      const differing = lacking.length > 0 ? [] : (predicted?.advice.value ?? []);
      made.showAdvice([...lacking, ...differing, ...failureIn(view.value, language.value)]);
    });
    return () => {
      stop();
      made.dispose();
      editor.current = null;
    };
  }, [run.id]);

  useEffect(() => editor.current?.setTheme(theme.value), [theme.value]);
  useEffect(() => editor.current?.setLanguage(language.value), [language.value]);

  return <div class="blocks__editor" ref={container} data-testid="editor" />;
}
