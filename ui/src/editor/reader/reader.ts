import * as Blockly from "blockly/core";
import "./editor.css";
import "./reader.css";
import { registerBlocks } from "../blocks";
import { upgradeWorkspace } from "../blocks/upgrade";
import { generateDocument } from "../generator";
import type { Language } from "../i18n/language";
import { addDifferenceSign, type Difference, SIGNS } from "./difference_sign";
import { bringIntoView, Highlight } from "./highlight";
import { applyLanguage } from "./locale";
import { Overview } from "./overview";
import { askOnlyDrawnFields, quietly } from "./quietly";
import { RENDERER, registerRenderer, setRing } from "./renderer";
import { ensureStartBlock, markLooseBlocks } from "./start_block";
import { blocklyTheme, showTheme, type ThemeName } from "./themes";
import { addZoomControls } from "./zoom_controls";

export interface ReaderOptions {
  container: HTMLElement;
  language: Language;
  theme: ThemeName;
  mediaPath: string;
}

/** From the corner of the workspace to the first block, in pixels. */
const MARGIN = 32;
/** Smaller blocks cannot be read; a longer program is scrolled. */
const SMALLEST = 0.7;
const LONGEST_WORDS = 90;

/** Blocks to look at only: a stored version, with what differs in it from another. */
export class BlocksReader {
  private readonly workspace: Blockly.WorkspaceSvg;
  private readonly pointed: Highlight;
  private readonly failed: Highlight;
  private readonly overview: Overview;
  private readonly zoom: ReturnType<typeof addZoomControls>;
  private readonly sizes: ResizeObserver;
  private marked: [string, readonly Difference[]][] = [];
  private shown: object = {};
  private language: Language;

  constructor(options: ReaderOptions) {
    this.language = options.language;
    applyLanguage(options.language);
    registerBlocks();
    registerRenderer();
    askOnlyDrawnFields();
    this.workspace = Blockly.inject(options.container, {
      theme: blocklyTheme(options.theme),
      renderer: RENDERER,
      media: options.mediaPath,
      sounds: false,
      readOnly: true,
      move: { scrollbars: true, drag: true, wheel: true },
      zoom: { controls: false, wheel: false, pinch: true, maxScale: 2, minScale: 0.4 },
    });
    options.container.classList.add("pinelReadOnly");
    this.pointed = new Highlight(this.workspace);
    this.failed = new Highlight(this.workspace, "fault");
    this.overview = new Overview(this.workspace);
    this.zoom = addZoomControls(this.workspace, () => this.workspace.zoomToFit());
    this.sizes = new ResizeObserver(() => this.resize());
    this.sizes.observe(options.container);
  }

  /** Shows a stored workspace from its start. Throws where it holds blocks this version does not know. */
  load(saved: object): void {
    this.shown = upgradeWorkspace(saved);
    this.clearMarks();
    this.fill();
    this.showFromTheStart(this.fittingScale());
  }

  /** Marks what differs, by the ids of blocks; a block that is not there is passed over. */
  mark(differences: ReadonlyMap<string, readonly Difference[]>): void {
    this.clearMarks();
    this.marked = [...differences];
    for (const [id, kinds] of this.marked) {
      const block = this.block(id);
      const [first] = kinds;
      if (!block || !first) continue;
      setRing(block, first, true);
      addDifferenceSign(block, kinds);
    }
  }

  /** Lights a block and brings it into view; null lights none. */
  point(id: string | null): void {
    this.pointed.show(id !== null && this.block(id) ? id : null);
  }

  /** Outlines the block at which a run broke off; null outlines none. */
  fail(id: string | null): void {
    this.failed.show(id !== null && this.block(id) ? id : null);
  }

  reveal(id: string): void {
    bringIntoView(this.workspace, id);
  }

  has(id: string): boolean {
    return this.block(id) !== null;
  }

  /** How far down a block stands, so that differences can be told from the top. */
  heightOf(id: string): number {
    return this.block(id)?.getRelativeToSurfaceXY().y ?? Number.POSITIVE_INFINITY;
  }

  /** What a block says, values within it included, without the blocks that hang in or below it. */
  words(id: string): string {
    const block = this.block(id);
    const words = block ? wordsOf(block).replace(/\s+/g, " ").replace(/ °/g, "°").trim() : "";
    return words.length > LONGEST_WORDS ? `${words.slice(0, LONGEST_WORDS - 1)}…` : words;
  }

  /** What the robot would get. */
  document(name: string): object {
    return generateDocument(this.workspace, name);
  }

  setTheme(theme: ThemeName): void {
    showTheme(this.workspace, theme);
  }

  /** What a screen reader calls this place, so that two of them can be told apart. */
  setName(name: string): void {
    const area = this.workspace.getParentSvg().querySelector(".blocklyWorkspace");
    area?.setAttribute("aria-label", name);
  }

  /** Blocks take their words when they are made: they are made again. */
  setLanguage(language: Language): void {
    if (language === this.language) return;
    this.language = language;
    applyLanguage(language);
    this.zoom.relabel();
    const marked = this.marked;
    this.clearMarks();
    this.fill();
    this.mark(new Map(marked));
  }

  dispose(): void {
    this.sizes.disconnect();
    this.zoom.remove();
    this.overview.dispose();
    this.workspace.dispose();
  }

  private fill(): void {
    this.pointed.show(null);
    this.failed.show(null);
    quietly(() => {
      this.workspace.clear();
      Blockly.serialization.workspaces.load(this.shown, this.workspace);
      ensureStartBlock(this.workspace);
      markLooseBlocks(this.workspace);
    });
    this.overview.refresh();
  }

  private clearMarks(): void {
    for (const sign of this.workspace.getCanvas().querySelectorAll(".pinelSign")) sign.remove();
    for (const [id] of this.marked) {
      const block = this.block(id);
      if (!block) continue;
      for (const kind of Object.keys(SIGNS) as Difference[]) setRing(block, kind, false);
    }
    this.marked = [];
  }

  /** As large as may be: a program that fits is seen whole, of a longer one its beginning. */
  fittingScale(): number {
    const box = this.workspace.getBlocksBoundingBox();
    const view = this.workspace.getMetricsManager().getViewMetrics();
    const wide = (view.width - 2 * MARGIN) / Math.max(1, box.right - box.left);
    const high = (view.height - 2 * MARGIN) / Math.max(1, box.bottom - box.top);
    return Math.max(SMALLEST, Math.min(1, wide, high));
  }

  showFromTheStart(scale: number): void {
    const { left, top } = this.workspace.getBlocksBoundingBox();
    this.workspace.setScale(scale);
    this.workspace.scroll(MARGIN - left * scale, MARGIN - top * scale);
  }

  private resize(): void {
    Blockly.svgResize(this.workspace);
    this.overview.refresh();
  }

  private block(id: string): Blockly.BlockSvg | null {
    return this.workspace.getBlockById(id) ?? this.startBlock(id);
  }

  /** There is one start block, whatever it was called in another version. */
  private startBlock(id: string): Blockly.BlockSvg | null {
    const [start] = this.workspace.getBlocksByType("program_start") as Blockly.BlockSvg[];
    return id === "start" ? (start ?? null) : null;
  }
}

function wordsOf(block: Blockly.Block): string {
  return block.inputList
    .filter((input) => input.isVisible())
    .map((input) => {
      const fields = input.fieldRow.map((field) => field.getText());
      const inner =
        input.type === Blockly.inputs.inputTypes.VALUE ? input.connection?.targetBlock() : null;
      return [...fields, inner ? wordsOf(inner) : ""].join(" ");
    })
    .join(" ");
}
