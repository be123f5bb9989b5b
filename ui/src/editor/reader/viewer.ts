import * as Blockly from "blockly/core";
import "../editor.css";
import "./reader.css";
import { registerBlocks } from "../../blocks";
import { generateDocument } from "../../blocks/generator";
import { shownWorkspace } from "../../blocks/loader";
import type { Language } from "../../i18n";
import { bringIntoView, Highlight } from "../decorations/highlight";
import { applyLanguage } from "../locale";
import { RENDERER, registerRenderer, setRing } from "../renderer";
import { dimLooseBlocks, ensureStartBlock } from "../start_block";
import { blocklyTheme, showTheme, type ThemeName } from "../themes";
import { Minimap } from "../viewport/minimap";
import { ScrollBars } from "../viewport/scroll_bars";
import { patchAriaUpdates, withoutEvents } from "../without_events";
import { addZoomControls } from "../zoom_controls";
import { addDifferenceBadge, BADGE_PATHS, type Difference } from "./difference_badge";

/** Settings of a read-only view of blocks. */
export interface ViewerOptions {
  container: HTMLElement;
  language: Language;
  theme: ThemeName;
  mediaPath: string;
  /** Minimum height of texts, in pixels of the page; the blocks grow with it. */
  minTextPx?: (() => number) | undefined;
}

/** Distance from the workspace's corner to the first block, in pixels. */
const MARGIN = 32;
/** Minimum legible scale; a longer program is scrolled. */
const MIN_SCALE = 0.7;
const MAX_SCALE = 1;
/** By how much larger than the minimum a short program is, if its texts have a minimum height. */
const SHORT_PROGRAM = 1.4;
const MAX_TEXT_LENGTH = 90;
const PX_PER_PT = 4 / 3;

/**
 * Read-only view of a stored version, with decorations on the blocks that differ from another
 * version.
 */
export class BlocksViewer {
  private readonly workspace: Blockly.WorkspaceSvg;
  private readonly pointed: Highlight;
  private readonly failed: Highlight;
  private readonly minimap: Minimap;
  private readonly scrollBars: ScrollBars;
  private readonly zoom: ReturnType<typeof addZoomControls>;
  private readonly sizes: ResizeObserver;
  private marked: [string, readonly Difference[]][] = [];
  private shown: object = {};
  private language: Language;
  private readonly minTextPx: (() => number) | undefined;

  constructor(options: ViewerOptions) {
    this.language = options.language;
    this.minTextPx = options.minTextPx;
    applyLanguage(options.language);
    registerBlocks();
    registerRenderer();
    patchAriaUpdates();
    this.workspace = Blockly.inject(options.container, {
      theme: blocklyTheme(options.theme),
      renderer: RENDERER,
      css: false, // the renderer adds it
      media: options.mediaPath,
      sounds: false,
      readOnly: true,
      move: { scrollbars: true, drag: true, wheel: true },
      zoom: { controls: false, wheel: false, pinch: true, maxScale: 4, minScale: 0.4 },
    });
    options.container.classList.add("pinelReadOnly");
    this.pointed = new Highlight(this.workspace);
    this.failed = new Highlight(this.workspace, "advice");
    this.minimap = new Minimap(this.workspace);
    this.scrollBars = new ScrollBars(this.workspace);
    this.zoom = addZoomControls(this.workspace, () => this.workspace.zoomToFit());
    this.sizes = new ResizeObserver(() => this.resize());
    this.sizes.observe(options.container);
  }

  /**
   * Shows a stored workspace from its start. Throws if it has blocks that this version does not
   * know.
   */
  load(saved: object): void {
    this.shown = shownWorkspace(saved);
    this.clearDifferences();
    this.fill();
    this.showFromTheStart(this.fittingScale());
  }

  /** Decorates differences by block id; ignores ids that are not in the workspace. */
  showDifferences(differences: ReadonlyMap<string, readonly Difference[]>): void {
    this.clearDifferences();
    this.marked = [...differences];
    for (const [id, kinds] of this.marked) {
      const block = this.block(id);
      const [first] = kinds;
      if (!block || !first) continue;
      setRing(block, first, true);
      addDifferenceBadge(block, kinds);
    }
  }

  /** Highlights a block and scrolls it into view; null clears the highlight. */
  point(id: string | null): void {
    this.pointed.show(id !== null && this.block(id) ? id : null);
  }

  /** Outlines the block at which a run failed; null clears the outline. */
  fail(id: string | null): void {
    this.failed.show(id !== null && this.block(id) ? id : null);
  }

  reveal(id: string): void {
    bringIntoView(this.workspace, id);
  }

  has(id: string): boolean {
    return this.block(id) !== null;
  }

  /** The ancestors of a block, nearest first: the block above or around it, and so on. */
  above(id: string): string[] {
    const found: string[] = [];
    for (let at = this.block(id)?.getParent(); at; at = at.getParent()) {
      found.push(at.type === "program_start" ? "start" : at.id);
    }
    return found;
  }

  /** Vertical position of a block, used to list differences from top to bottom. */
  heightOf(id: string): number {
    return this.block(id)?.getRelativeToSurfaceXY().y ?? Number.POSITIVE_INFINITY;
  }

  /** Text of a block with the values in its inputs, without the blocks inside or below it. */
  textOf(id: string): string {
    const block = this.block(id);
    const text = block ? inlineText(block).replace(/\s+/g, " ").replace(/ °/g, "°").trim() : "";
    return text.length > MAX_TEXT_LENGTH ? `${text.slice(0, MAX_TEXT_LENGTH - 1)}…` : text;
  }

  /** The program document that would be sent to the robot. */
  document(name: string): object {
    return generateDocument(this.workspace, name);
  }

  setTheme(theme: ThemeName): void {
    showTheme(this.workspace, theme);
  }

  /** Sets the accessible name, which distinguishes two viewers on one page. */
  setName(name: string): void {
    const area = this.workspace.getParentSvg().querySelector(".blocklyWorkspace");
    area?.setAttribute("aria-label", name);
  }

  /** Sets the language; recreates the blocks, because they read their texts at creation. */
  setLanguage(language: Language): void {
    if (language === this.language) return;
    this.language = language;
    applyLanguage(language);
    this.zoom.relabel();
    const marked = this.marked;
    this.clearDifferences();
    this.fill();
    this.showDifferences(new Map(marked));
  }

  dispose(): void {
    this.sizes.disconnect();
    this.zoom.remove();
    this.minimap.dispose();
    this.scrollBars.dispose();
    this.workspace.dispose();
  }

  private fill(): void {
    this.pointed.show(null);
    this.failed.show(null);
    withoutEvents(() => {
      this.workspace.clear();
      Blockly.serialization.workspaces.load(this.shown, this.workspace);
      ensureStartBlock(this.workspace);
      dimLooseBlocks(this.workspace);
    });
    this.minimap.refresh();
    this.scrollBars.refresh();
  }

  private clearDifferences(): void {
    for (const badge of this.workspace.getCanvas().querySelectorAll(".pinelSign")) badge.remove();
    for (const [id] of this.marked) {
      const block = this.block(id);
      if (!block) continue;
      for (const kind of Object.keys(BADGE_PATHS) as Difference[]) setRing(block, kind, false);
    }
    this.marked = [];
  }

  /** The largest scale at which the whole program fits, within the bounds. */
  fittingScale(): number {
    const [min, max] = this.scaleBounds();
    const box = this.workspace.getBlocksBoundingBox();
    const view = this.workspace.getMetricsManager().getViewMetrics();
    const wide = (view.width - 2 * MARGIN) / Math.max(1, box.right - box.left);
    const high = (view.height - 2 * MARGIN) / Math.max(1, box.bottom - box.top);
    return Math.max(min, Math.min(max, wide, high));
  }

  showFromTheStart(scale: number): void {
    const { left, top } = this.workspace.getBlocksBoundingBox();
    this.workspace.setScale(scale);
    this.workspace.scroll(MARGIN - left * scale, MARGIN - top * scale);
  }

  private scaleBounds(): [min: number, max: number] {
    if (!this.minTextPx) return [MIN_SCALE, MAX_SCALE];
    const { FIELD_TEXT_FONTSIZE } = this.workspace.getRenderer().getConstants();
    const min = this.minTextPx() / (FIELD_TEXT_FONTSIZE * PX_PER_PT);
    return [min, min * SHORT_PROGRAM];
  }

  private resize(): void {
    Blockly.svgResize(this.workspace);
    if (this.minTextPx) this.showLarge();
    this.minimap.refresh();
    this.scrollBars.refresh();
  }

  /** After a resize: the program in its size for the new window, with the decorated block in view. */
  private showLarge(): void {
    this.showFromTheStart(this.fittingScale());
    const shown = this.pointed.blockId ?? this.failed.blockId;
    if (shown) this.reveal(shown);
  }

  private block(id: string): Blockly.BlockSvg | null {
    return this.workspace.getBlockById(id) ?? this.startBlock(id);
  }

  /** The start block, if the id is "start"; in some stored versions its own id differs. */
  private startBlock(id: string): Blockly.BlockSvg | null {
    const [start] = this.workspace.getBlocksByType("program_start") as Blockly.BlockSvg[];
    return id === "start" ? (start ?? null) : null;
  }
}

function inlineText(block: Blockly.Block): string {
  return block.inputList
    .filter((input) => input.isVisible())
    .map((input) => {
      const fields = input.fieldRow.map((field) => field.getText());
      const inner =
        input.type === Blockly.inputs.inputTypes.VALUE ? input.connection?.targetBlock() : null;
      return [...fields, inner ? inlineText(inner) : ""].join(" ");
    })
    .join(" ");
}
