import * as Blockly from "blockly/core";
import "./editor.css";
import { registerBlocks } from "../blocks";
import type { Level } from "../blocks/definition";
import type { BlockType } from "../blocks/definitions";
import { addToFieldNote } from "../blocks/fields/field_note";
import { generateDocument } from "../blocks/generator";
import { setKnownPlaces } from "../blocks/known_places";
import { type KnownSigns, setKnownSigns } from "../blocks/known_signs";
import { shownWorkspace } from "../blocks/loader";
import { blockText } from "../blocks/texts";
import { EVERYTHING, flyoutBlock, type OfferedActions, toolbox } from "../blocks/toolbox/toolbox";
import type { Language } from "../i18n";
import { watchContent } from "./changes";
import { Breakpoints } from "./decorations/breakpoints";
import { type Fault, FaultDecorations } from "./decorations/fault_decorations";
import { bringIntoView, Highlight } from "./decorations/highlight";
import { StartHint } from "./decorations/start_hint";
import { ValueBubble } from "./decorations/value_bubble";
import { WarningDecorations } from "./decorations/warning_decorations";
import type { Editor } from "./editor";
import { EditorElements } from "./elements";
import { injectWorkspace } from "./inject";
import { applyLanguage } from "./locale";
import type { EditorOptions } from "./options";
import { restoreFocus } from "./restore_focus";
import { dimLooseBlocks, ensureStartBlock } from "./start_block";
import { pageFont, showTheme, type ThemeName } from "./themes";
import { appendBlock } from "./toolbox/append";
import { PinelToolbox } from "./toolbox/flyout";
import { addTrashClosing } from "./toolbox/trash";
import { interceptEmptyUndo, undoInto } from "./undo";
import { Minimap } from "./viewport/minimap";
import { ScrollBars } from "./viewport/scroll_bars";
import { scrollToStart, showFromTheStart } from "./viewport/start_view";
import { withoutEvents } from "./without_events";
import { addZoomControls } from "./zoom_controls";

export type { Editor, Fault };

/**
 * Minimum width of the editor for an open flyout: categories, flyout, and a turn block in a loop.
 */
const MIN_WIDTH_WITH_FLYOUT_PX = 730;

/** Creates an editor without any block; only `load` adds the start block. */
export function createEditor(options: EditorOptions): Editor {
  applyLanguage(options.language);
  registerBlocks();
  return new BlockEditor(options);
}

class BlockEditor implements Editor {
  readonly elements: EditorElements;
  private readonly workspace: Blockly.WorkspaceSvg;
  private readonly faults: FaultDecorations;
  private readonly advice: FaultDecorations;
  private readonly running: Highlight;
  private readonly warnings: WarningDecorations;
  private readonly breakpoints: Breakpoints | undefined;
  private readonly values: ValueBubble | undefined;
  private readonly minimap: Minimap;
  private readonly scrollBars: ScrollBars;
  private readonly hint = new StartHint();
  private readonly controls: ReturnType<typeof addZoomControls>[];
  private readonly sizes: ResizeObserver;
  private readonly disposeFocusRestorer: () => void;
  private known = "";
  private level: Level;
  private offered: OfferedActions;
  private language: Language;
  private isRunning = false;
  private isPinned = false;
  private disposed = false;

  constructor(private readonly options: EditorOptions) {
    this.level = options.level ?? EVERYTHING;
    this.language = options.language;
    this.offered = options.offered ?? null;
    this.workspace = injectWorkspace({ ...options, level: this.level }, () => this.offered);
    this.pinFlyout();
    this.faults = new FaultDecorations(this.workspace);
    this.advice = new FaultDecorations(this.workspace, "advice");
    this.running = new Highlight(this.workspace);
    this.elements = new EditorElements(this.workspace, this.running);
    this.warnings = new WarningDecorations(this.workspace);
    const { onBreakpoints } = options;
    this.breakpoints = onBreakpoints && new Breakpoints(this.workspace, onBreakpoints);
    this.minimap = new Minimap(this.workspace);
    this.scrollBars = new ScrollBars(this.workspace);
    this.values = options.evaluate && new ValueBubble(this.workspace, options.evaluate);
    const zoom = addZoomControls(this.workspace, () => this.zoomToFit());
    this.controls = [zoom, addTrashClosing(this.workspace)];
    this.sizes = new ResizeObserver(() => this.resize());
    this.sizes.observe(options.container);
    this.disposeFocusRestorer = restoreFocus(this.workspace);
    this.measureAgainWithFont();
    this.workspace.addChangeListener((event) => this.onEvent(event));
    watchContent(this.workspace, () => this.onContent());
    interceptEmptyUndo(this.workspace, () => options.onNothingToUndo?.());
  }

  load(saved: object | null): void {
    const workspace = saved && shownWorkspace(saved);
    if (workspace) normalized(workspace);
    Blockly.hideChaff();
    this.running.show(null);
    this.clearDecorations();
    this.replace(workspace);
    showFromTheStart(this.workspace);
    this.offerFlyout();
    this.workspace.clearUndo();
    this.known = this.fingerprint();
  }

  content(): { workspace: object; document: object } {
    return {
      workspace: Blockly.serialization.workspaces.save(this.workspace),
      document: this.document(),
    };
  }

  document(): object {
    return generateDocument(this.workspace, this.options.programName?.() ?? "");
  }

  highlight(blockId: string | null): void {
    this.running.show(blockId);
  }

  showFaults(faults: Fault[]): void {
    this.faults.show(faults);
  }

  append(type: BlockType): void {
    if (this.workspace.isReadOnly()) return;
    appendBlock(flyoutBlock(type, EVERYTHING, this.workspace), this.workspace);
  }

  showAdvice(advice: readonly Fault[]): void {
    this.advice.show(advice);
  }

  reveal(blockId: string): void {
    bringIntoView(this.workspace, blockId);
    const marks = this.advice.has(blockId) ? this.advice : this.faults;
    void marks.openBubble(blockId, true);
  }

  setLanguage(language: Language): void {
    if (language === this.language) return;
    this.language = language;
    applyLanguage(language);
    this.updateToolbox();
    for (const { relabel } of this.controls) relabel();
    // blocks read their texts when they are created
    this.remake();
  }

  setTheme(theme: ThemeName): void {
    showTheme(this.workspace, theme);
  }

  setLevel(level: Level, offered: OfferedActions = null): void {
    if (level === this.level && String(offered) === String(this.offered)) return;
    this.level = level;
    this.offered = offered;
    Blockly.hideChaff();
    this.updateToolbox();
    this.pinFlyout();
  }

  setSigns(signs: KnownSigns | null): void {
    setKnownSigns(signs);
    this.warnings.refresh();
  }

  setPlaces(names: readonly string[] | null): void {
    setKnownPlaces(names);
    this.warnings.refresh();
  }

  setReadOnly(readOnly: boolean): void {
    Blockly.hideChaff();
    this.workspace.setIsReadOnly(readOnly);
    this.workspace.getToolbox()?.setVisible(!readOnly);
    this.pinFlyout();
    this.options.container.classList.toggle("pinelReadOnly", readOnly);
    this.refreshHint();
    this.resize();
  }

  setRunning(running: boolean): void {
    this.isRunning = running;
  }

  undo(): void {
    this.workspace.undo(false);
  }

  redo(): void {
    this.workspace.undo(true);
  }

  undoTo(saved: object | null): boolean {
    const workspace = shownWorkspace(saved ?? {});
    const isUnchanged = saved
      ? JSON.stringify(normalized(workspace)) === this.fingerprint()
      : this.workspace.getAllBlocks(false).length <= 1;
    if (isUnchanged) return false;
    Blockly.hideChaff();
    undoInto(this.workspace, workspace, (state) => this.replaceForUndo(state));
    return true;
  }

  tidy(): void {
    this.workspace.cleanUp();
  }

  zoomToFit(): void {
    this.workspace.zoomToFit();
  }

  resize(): void {
    const { isPinned } = this;
    Blockly.svgResize(this.workspace);
    this.pinFlyout();
    if (this.isPinned !== isPinned) scrollToStart(this.workspace);
    for (const marks of [this.faults, this.advice]) marks.placeBubbles();
    this.minimap.refresh();
    this.scrollBars.refresh();
  }

  dispose(): void {
    // Blockly reports the last edit only when its field editor closes
    Blockly.hideChaff();
    this.onContent();
    this.disposed = true;
    setKnownSigns(null);
    setKnownPlaces(null);
    this.sizes.disconnect();
    for (const { remove } of this.controls) remove();
    this.values?.dispose();
    this.minimap.dispose();
    this.scrollBars.dispose();
    this.disposeFocusRestorer();
    this.workspace.dispose();
  }

  /**
   * Recreates blocks that were drawn before the font was loaded: their width does not fit their
   * text.
   */
  private measureAgainWithFont(): void {
    const font = `600 18px ${pageFont()}`;
    if (!document.fonts || document.fonts.check(font)) return;
    void document.fonts.load(font).then(() => {
      if (!this.disposed && !this.workspace.isDragging()) this.remake();
    });
  }

  /** Recreates every block in place; ids, undo stack and decorations are preserved. */
  private remake(): void {
    Blockly.hideChaff();
    const running = this.running.blockId;
    const focused = this.focusedBlock();
    const { shown: faults } = this.faults;
    const { shown: advice } = this.advice;
    this.running.show(null);
    this.clearDecorations();
    this.replace(Blockly.serialization.workspaces.save(this.workspace));
    this.faults.show(faults);
    this.advice.show(advice);
    this.running.show(running);
    const again = focused && this.workspace.getBlockById(focused);
    if (again) Blockly.getFocusManager().focusNode(again);
  }

  /** Id of the block that has keyboard focus; null when no block of this workspace has it. */
  private focusedBlock(): string | null {
    if (!this.options.container.contains(document.activeElement)) return null;
    const node = Blockly.getFocusManager().getFocusedNode();
    return node instanceof Blockly.BlockSvg && node.workspace === this.workspace ? node.id : null;
  }

  /** Updates the toolbox. Blockly then shows it even in a read-only workspace; hides it again. */
  private updateToolbox(): void {
    this.workspace.updateToolbox(toolbox(this.level, this.offered));
    if (this.workspace.isReadOnly()) this.workspace.getToolbox()?.setVisible(false);
  }

  /**
   * In the first level the flyout stays open if the editor is wide enough, so that beginners see
   * all blocks.
   */
  private pinFlyout(): void {
    const blocklyToolbox = this.workspace.getToolbox();
    const hasRoom = this.options.container.clientWidth >= MIN_WIDTH_WITH_FLYOUT_PX;
    this.isPinned = this.level === 1 && hasRoom && !this.workspace.isReadOnly();
    this.options.container.classList.toggle("pinelPaletteStays", this.isPinned);
    if (blocklyToolbox instanceof PinelToolbox) blocklyToolbox.setPinned(this.isPinned);
  }

  private clearDecorations(): void {
    this.faults.clear();
    this.advice.clear();
  }

  /**
   * Opens the flyout for an empty program of the first level; it closes after the first block if it
   * is not pinned.
   */
  private offerFlyout(): void {
    const blocklyToolbox = this.workspace.getToolbox();
    const isEmpty = this.workspace.getTopBlocks(false).every((block) => !block.getNextBlock());
    const isOffered = isEmpty && this.level === 1 && !this.workspace.isReadOnly();
    if (blocklyToolbox instanceof PinelToolbox && isOffered) blocklyToolbox.offer();
  }

  private replaceForUndo(workspace: object): void {
    this.running.show(null);
    this.clearDecorations();
    this.replace(workspace);
    this.onContent();
  }

  private replace(workspace: object | null): void {
    withoutEvents(() => {
      this.hint.hide();
      this.workspace.clear();
      if (workspace) Blockly.serialization.workspaces.load(workspace, this.workspace);
      ensureStartBlock(this.workspace);
      dimLooseBlocks(this.workspace);
    });
    this.warnings.forget();
    this.warnings.refresh();
    this.minimap.refresh();
    this.scrollBars.refresh();
    this.breakpoints?.refresh();
    this.refreshHint();
  }

  private onEvent(event: Blockly.Events.Abstract): void {
    if (event.type === Blockly.Events.BLOCK_DRAG) this.refreshHint();
    if (event.isUiEvent) return;
    const { blockId, newParentId, oldParentId } = event as Partial<Blockly.Events.BlockMove>;
    for (const id of [blockId, newParentId, oldParentId]) this.faults.clearBlock(id);
    if (this.isRunning) this.announceNextRun(event);
  }

  private announceNextRun(event: Blockly.Events.Abstract): void {
    if (event.type !== Blockly.Events.BLOCK_CHANGE) return;
    const { blockId, element, name } = event as Blockly.Events.BlockChange;
    const block = blockId && this.workspace.getBlockById(blockId);
    const field = block && element === "field" ? block.getField(name ?? "") : null;
    if (field) addToFieldNote(field, blockText("NEXT_RUN"));
  }

  private onContent(): void {
    dimLooseBlocks(this.workspace);
    this.breakpoints?.refresh();
    this.warnings.refresh();
    this.refreshHint();
    const fingerprint = this.fingerprint();
    if (fingerprint === this.known) return;
    this.known = fingerprint;
    this.options.onChange(this.content());
  }

  private refreshHint(): void {
    const [start] = this.workspace.getBlocksByType("program_start") as Blockly.BlockSvg[];
    const needsHint = start && !start.getNextBlock() && !this.workspace.isDragging();
    if (needsHint && !this.workspace.isReadOnly()) this.hint.show(start);
    else this.hint.hide();
  }

  private fingerprint(): string {
    return JSON.stringify(Blockly.serialization.workspaces.save(this.workspace));
  }
}

/**
 * Loads the content into a scratch workspace; returns it as it would be saved. Throws if it cannot
 * be loaded.
 */
function normalized(workspace: object): object {
  const trial = new Blockly.Workspace();
  try {
    withoutEvents(() => Blockly.serialization.workspaces.load(workspace, trial));
    return Blockly.serialization.workspaces.save(trial);
  } finally {
    trial.dispose();
  }
}
