import { computed, effect, type Signal, signal } from "@preact/signals";
import { api } from "../api/client";
import { ApiError } from "../api/errors";
import type { EditorContent, LiveCommand, SavedState } from "../api/model";
import { versionsApi } from "../api/versions";
import { commandCount, MAX_SHOWN_COMMANDS, workspaceOf } from "../blocks/loader";
import { expectedSigns, hasCapture } from "../camera/expected";
import { canonicalSign } from "../camera/signs";
import type { Fault as BlockFault, Editor } from "../editor";
import { language, texts } from "../i18n";
import { problemOf, Refused } from "../kit/requests/problem";
import { followPrediction } from "../prediction/live_prediction";
import { besideBlock, failureOf } from "../run/failure";
import type { StoredProgram } from "../run/idle_parts";
import { inspectedTick, shown } from "../run/inspected_tick";
import { verdictOf, withVerdict } from "../run/judgement";
import * as robot from "../run/live";
import {
  activeRealLink,
  chosenRobot,
  isChecked,
  robotHasRun,
  robotOfRun,
} from "../run/real/real_robot";
import { robotSentence } from "../run/real/robot_sentence";
import { isLive, runningBlock } from "../run/reducer";
import { parameterIn, type Sentence, sentenceOf } from "../run/sentence";
import { valueText } from "../run/values";
import type { RobotHold } from "../scene/Scene";
import { subscribeToRings } from "../scene/tools/sensor_rings";
import { level } from "../shell/level";
import { judged, problem, report, robotOf } from "../shell/session";
import { CloudControl } from "./cloud/cloud_control";
import { breakpoints, runSettings, syncRunSettings } from "./debug/debugging";
import { watchSensors } from "./debug/sensor_values";
import { Ghost } from "./ghost";
import { MissionSheet } from "./mission_sheet";
import type { OpenProgram } from "./program/open_program";
import { renameProgram } from "./program/rename";
import { setupOf } from "./program/setup";
import { StoredUndo } from "./program/stored_undo";
import { holdOf, StartChoice } from "./start_choice";
import { stopRobot } from "./stop_robot";
import {
  beforeRunSentence,
  calm,
  pastSentence,
  serverSentence,
  withReturnAdvice,
} from "./studio_sentence";
import { WorldControl } from "./world_control";

const POINTING_MS = 2500;

export interface Replaced {
  readonly workspace: object;
  /** Origin of the current blocks: from Python, or restored. */
  readonly now: "placed" | "broughtBack";
}

/** Shared state of the studio's panes: the open program, its editor and the robot. */
export class StudioControl {
  editor: Editor | null = null;
  /** Whether Run was pressed without any command in the program. */
  readonly asked = signal(false);
  /** Set if Run or Step was pressed for a real robot before its check list was completed; else null. */
  readonly asksBefore = signal<{ paused: boolean } | null>(null);
  /** Whether the live or last run belongs to this program. */
  readonly mine = computed(() => robot.liveRun.value?.program_id === this.open.id);
  readonly missionSheet: MissionSheet;
  readonly worlds: WorldControl;
  readonly start: StartChoice;
  readonly sentence = computed<Sentence>(() => this.computeSentence());
  /** The innermost running block of this program, now or at the inspected tick. */
  readonly running = computed(() => (this.mine.value ? runningBlock(shown.value) : null));
  /** Whether the program has a block that beeps. */
  readonly beeps = computed(() =>
    JSON.stringify(this.open.content.value?.document ?? null).includes('"action":"beep"'),
  );
  /** The signs with which the running program compares the answer to a capture. */
  readonly expectedSigns = computed(() =>
    this.mine.value ? expectedSigns(this.documentThatRuns()).map(canonicalSign) : [],
  );
  /** Whether the program has a block that waits for a sign. */
  readonly captures = computed(() => hasCapture(this.open.content.value?.document ?? null));
  private readonly lacking = computed(robotSentence);
  private readonly activeBlockId = computed(() => this.running.value?.block ?? null);
  private readonly failure = computed(() => {
    const { phase, ending } = robot.live.value;
    return phase === "failed" && this.mine.value ? ending : null;
  });
  /** The missing check of the last run's verdict, with its block; null once the program is changed. */
  readonly advice = computed<BlockFault | null>(() => {
    const { value: edited } = this.edited;
    const view = robot.live.value;
    // the verdict may arrive before the next redraw, which shows the end of the run
    const isOver = this.mine.value && !edited && !isLive(view);
    const verdict = isOver ? verdictOf(view.run, judged.value) : null;
    if (!verdict?.missing || !verdict.block || verdict.block === this.failure.value?.block) {
      return null;
    }
    return { block: verdict.block, message: verdict.missing, remedy: "", isQuiet: true };
  });
  /** The failure of the last run at its block, until the program changes. */
  private readonly failedBlock = computed(() =>
    this.edited.value ? [] : failureOf(this.failure.value, language.value),
  );
  /** The blocks before the whole program was replaced, for undo. */
  readonly replaced = signal<Replaced | null>(null);
  /** Whether the blocks have changed since the run started. */
  private readonly edited: Signal<boolean>;
  private ran: EditorContent | null = null;
  /** The failed block that the editor has scrolled to. */
  private revealed: string | null = null;
  private pointing = 0;
  private busy = false;

  private storedUndo: StoredUndo;

  constructor(readonly open: OpenProgram) {
    this.storedUndo = new StoredUndo(open);
    const ranVersion = this.mine.peek() ? robot.liveRun.peek()?.version_id : null;
    const openVersion = open.program.version?.id;
    this.edited = signal(Boolean(ranVersion && openVersion && ranVersion !== openVersion));
    this.missionSheet = new MissionSheet(open, this.mine);
    this.worlds = new WorldControl(open);
    this.start = new StartChoice(open, this.worlds);
    this.hold = holdOf(this.start, this.robot);
  }

  /** The world of the current or next run. */
  get world() {
    return this.start.world;
  }

  /** The robot on the floor: of the run, else of the next run. */
  readonly robot = computed(() => {
    const { value: run } = robot.liveRun;
    if (run && robot.live.value.run !== null) return robotOf(run.model);
    const isChosen = level.value > 1 && !chosenRobot.value && !this.open.mission.value;
    return robotOf(isChosen ? this.open.setup.value.model : null);
  });

  /** The robot in a further case of the mission, beside that of the group. */
  readonly ghost = new Ghost(this.robot);

  /** The program in many robots at once. */
  readonly cloud = new CloudControl(this);

  /** Handling of the robot on the floor: dragging, sensors. */
  readonly hold: RobotHold;

  /** Connects an editor to the program; returns the function that disconnects it. */
  attach(editor: Editor): () => void {
    this.editor = editor;
    const stops = [
      syncRunSettings(this.open, report),
      subscribeToRings(report),
      followPrediction(),
      watchSensors(() => (this.mine.peek() ? this.documentThatRuns() : null)),
      effect(() => editor.highlight(this.activeBlockId.value)),
      effect(() => {
        editor.showFaults([...this.open.faults.value]);
        // after the faults, so that a screen reader reads the verdict if both change at once
        this.showAdvice(editor);
      }),
      effect(() => editor.setRunning(this.mine.value && isLive(robot.live.value))),
      this.missionSheet.openAfterPasses(),
      this.cloud.listen(),
    ];
    return () => {
      breakpoints.value = []; // those of the live run, too: another program shows none
      for (const stop of stops) stop();
      this.editor = null;
    };
  }

  /** Shows a failed run at its block, and scrolls there once: the group may scroll elsewhere afterwards. */
  private showAdvice(editor: Editor): void {
    const { value: failed } = this.failedBlock;
    const { value: advice } = this.advice;
    const others = [advice, this.cloud.advice.value].filter((one) => one !== null);
    editor.showAdvice([...others, ...failed]);
    const block = failed[0]?.block ?? null;
    if (block !== null && block !== this.revealed) editor.reveal(block);
    this.revealed = block;
  }

  onEdit(content: EditorContent): void {
    this.edited.value = true;
    this.open.edit(content);
  }

  /** Continues undo with versions stored before this session. */
  undoPast(): void {
    const tryRestore = (workspace: object | null) => this.editor?.undoTo(workspace) ?? true;
    this.storedUndo.back(tryRestore).catch((error) => this.reportError(error));
  }

  /** Restores a stored version as an undo step: redo reverts it. */
  async restoreVersion(id: string): Promise<void> {
    const version = await versionsApi.version(id);
    this.editor?.undoTo(version.workspace);
    this.open.setWorld(version.world);
    this.open.changeSetup(setupOf(version));
    this.open.setStoredVersion(id);
  }

  /** Replaces the blocks by the blocks of a document, and gives the program the name of the document. */
  async replaceBlocks(document: object): Promise<void> {
    const n = commandCount(document);
    if (n > MAX_SHOWN_COMMANDS) {
      const { tooLong, tooLongRemedy } = texts.value.python;
      throw new Refused(tooLong({ n, most: MAX_SHOWN_COMMANDS }), tooLongRemedy);
    }
    const { name } = document as { name?: string };
    if (name) await renameProgram(name);
    this.swapBlocks(workspaceOf(document), "placed");
  }

  /** Exchanges the current blocks with the replaced ones. */
  swapBack(): void {
    const { value: replaced } = this.replaced;
    if (!replaced) return;
    this.swapBlocks(replaced.workspace, replaced.now === "placed" ? "broughtBack" : "placed");
  }

  private swapBlocks(workspace: object, now: Replaced["now"]): void {
    const { editor } = this;
    if (!editor) return;
    const before = editor.content().workspace;
    editor.load(workspace);
    this.storedUndo = new StoredUndo(this.open);
    this.replaced.value = { workspace: before, now };
    this.onEdit(editor.content());
  }

  /** Value of an expression in the paused run, as text. */
  evaluate(expression: unknown): Promise<string> | null {
    const { run, phase } = robot.live.peek();
    if (!run || phase !== "paused" || !this.mine.peek()) return null;
    return api.command(run, { do: "evaluate", expression }).then(
      ({ value, problem }) => problem ?? valueText(value, texts.value, language.value),
      (error) => problemOf(error).message,
    );
  }

  /** Saves the program and runs it; with `paused` it pauses before its first block. */
  async run(paused = false): Promise<void> {
    if (this.busy || isLive(robot.live.value)) return;
    if (this.cannotStart()) return;
    if (chosenRobot.peek() && !isChecked.peek()) this.asksBefore.value = { paused };
    else await this.drive({ paused });
  }

  /** Drives the program in many robots at once, in a case of the mission, and tells about faults as `run` does. */
  async startCloud(number?: number): Promise<void> {
    if (this.busy || isLive(robot.live.value) || this.cannotStart()) return;
    await this.whileBusy(() => this.cloud.begin(number));
  }

  readonly runRobot = (seed: number): void => void this.cloud.runOne(seed);

  /** Saves the program and runs it with further options. */
  async drive(options: Partial<robot.RunOptions>): Promise<void> {
    if (this.busy || isLive(robot.live.value)) return;
    await this.whileBusy(() => this.saveAndStart(options));
  }

  /** Shows what prevents any run: a faulty world, or no blocks. */
  private cannotStart(): boolean {
    this.missionSheet.close();
    if (this.worlds.isFaulty.peek()) this.worlds.edit();
    else if (this.open.isEmpty) this.asked.value = true;
    else return false;
    return true;
  }

  /** Saves the content on the screen; content already on disk creates no new version. Null if it has faults. */
  async savedVersion(): Promise<SavedState | null> {
    if (this.editor) this.open.edit(this.editor.content());
    const version = await this.open.autosave.flush();
    if (version && version.faults.length === 0) return version;
    this.showFirst();
    return null;
  }

  private async whileBusy(work: () => Promise<void>): Promise<void> {
    this.busy = true;
    problem.value = null;
    try {
      await work();
    } catch (error) {
      if (error instanceof ApiError && error.faults.length > 0)
        this.open.faults.value = error.faults;
      else this.reportError(error);
    } finally {
      this.busy = false;
    }
  }

  private async saveAndStart(more: Partial<robot.RunOptions>): Promise<void> {
    const version = await this.savedVersion();
    if (!version) return;
    this.ran = this.open.content.value;
    const start = this.start.start.value;
    const options = {
      ...runSettings(this.open, more.paused ?? false),
      ...(start ? { start } : {}),
      ...robotOfRun(),
      ...more,
    };
    const started = robot.start(version.id, this.worlds.name.value, options);
    // only now, because `start` has cleared the previous run: its failure must not reappear
    this.edited.value = false;
    await started;
    robotHasRun();
  }

  /** Reports an error; a failed save has its own line. */
  private reportError(error: unknown): void {
    if (error !== this.open.autosave.problem.peek()) report(error);
  }

  showFirst(): void {
    const first = this.open.faults.value.find((fault) => fault.block);
    if (first) this.goTo(first);
  }

  /** Scrolls to the block of a fault and highlights it for `POINTING_MS`, with the fault's text. */
  goTo({ block }: BlockFault): void {
    if (!block) return;
    this.editor?.highlight(block);
    this.editor?.reveal(block);
    clearTimeout(this.pointing);
    this.pointing = window.setTimeout(
      () => this.editor?.highlight(this.activeBlockId.value),
      POINTING_MS,
    );
  }

  goToAdvice(): void {
    const { value: advice } = this.advice;
    if (advice) this.goTo(advice);
  }

  /** Sends a command to the live run; reports failures. */
  send(command: LiveCommand): void {
    robot.command(command).catch(report);
  }

  stop(): void {
    this.cloud.stop();
    stopRobot();
  }

  private computeSentence(): Sentence {
    const { status, run, robot: real } = texts.value;
    const view = robot.live.value;
    const context = {
      texts: texts.value,
      language: language.value,
      parameterOf: (pointer: string, name: string) =>
        parameterIn(this.documentThatRuns(), pointer, name),
      program: this.programThatRuns(),
    };
    if (inspectedTick.value && this.mine.value) return pastSentence(context) ?? calm(status.ready);
    if (isLive(view) && view.run && !this.mine.value) {
      return { text: run.other, detail: "", tone: "notice" };
    }
    const { value: lacking } = this.lacking;
    if (view.phase === "starting" && activeRealLink.value) {
      return lacking ?? { text: real.searching, detail: real.searchingHow, tone: "calm" };
    }
    if (this.asksBefore.value) return { text: real.before.first, detail: "", tone: "notice" };
    if (isLive(view)) {
      const now = sentenceOf(view, context) ?? calm(status.ready);
      return this.edited.value ? { ...now, detail: status.nextRun } : now;
    }
    const before = beforeRunSentence(this.open, this.worlds, this.asked.value);
    if (before) return before;
    const ended = this.mine.value ? sentenceOf(view, context) : null;
    const isOutdated = this.edited.value && ended !== null && ended.tone !== "done";
    if (ended && !isOutdated)
      return withReturnAdvice(
        besideBlock(
          withVerdict(ended, view.run, judged.value, texts.value),
          this.failedBlock.value,
        ),
      );
    const missing = serverSentence();
    if (missing) return missing;
    const over = view.ending && !this.mine.value ? run.otherEnded : status.ready;
    return lacking ?? withReturnAdvice(calm(over));
  }

  /** The document of the live run; for a run of another window, the document from the server. */
  private documentThatRuns(): unknown {
    return this.programThatRuns()?.document ?? null;
  }

  private programThatRuns(): StoredProgram | null {
    const { value: run } = robot.liveRun;
    return run && "version" in run ? run.version : this.ran;
  }
}
