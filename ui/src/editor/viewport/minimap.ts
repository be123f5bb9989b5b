import type * as Blockly from "blockly/core";
import { blockText } from "../../blocks/texts";

/** Size of the canvas, in CSS pixels. */
const WIDTH = 104;
const HEIGHT = 176;
/** The map is shown if the program is longer than this multiple of the viewport. */
const LONG = 1.4;
const PADDING = 6;

/**
 * Minimap of a long program with a frame around the viewport. Pressing or dragging in it scrolls.
 */
export class Minimap {
  private readonly canvas = document.createElement("canvas");
  private frame = 0;
  private scale = 1;
  private origin = { x: 0, y: 0 };

  constructor(private readonly workspace: Blockly.WorkspaceSvg) {
    const { canvas } = this;
    canvas.className = "pinelOverview";
    canvas.hidden = true;
    canvas.title = blockText("OVERVIEW");
    // hidden from screen readers: blocks and arrow keys give the same information and actions
    canvas.setAttribute("aria-hidden", "true");
    workspace.getInjectionDiv().append(canvas);
    workspace.addChangeListener(this.refresh);
    canvas.addEventListener("pointerdown", this.onPointer);
    canvas.addEventListener("pointermove", this.onPointer);
  }

  /** Redraws at the next animation frame; several calls before it cause one redraw. */
  readonly refresh = (): void => {
    this.frame ||= requestAnimationFrame(() => {
      this.frame = 0;
      this.draw();
    });
  };

  dispose(): void {
    cancelAnimationFrame(this.frame);
    this.workspace.removeChangeListener(this.refresh);
    this.canvas.remove();
  }

  private draw(): void {
    const metrics = this.workspace.getMetricsManager();
    const content = metrics.getContentMetrics(true);
    const view = metrics.getViewMetrics(true);
    this.canvas.hidden = content.height < LONG * view.height;
    const pen = this.canvas.hidden ? null : this.cleared();
    if (!pen) return;
    const left = Math.min(content.left, view.left);
    const top = Math.min(content.top, view.top);
    const right = Math.max(content.left + content.width, view.left + view.width);
    const bottom = Math.max(content.top + content.height, view.top + view.height);
    this.scale = Math.min(
      (WIDTH - 2 * PADDING) / (right - left),
      (HEIGHT - 2 * PADDING) / (bottom - top),
    );
    this.origin = { x: left, y: top };
    for (const block of this.workspace.getAllBlocks(false)) this.drawBlock(pen, block);
    pen.strokeStyle = getComputedStyle(this.canvas).color;
    pen.lineWidth = 2;
    pen.strokeRect(...this.placed(view.left, view.top, view.width, view.height));
  }

  private drawBlock(pen: CanvasRenderingContext2D, block: Blockly.BlockSvg): void {
    if (block.outputConnection) return;
    const { left, top, right, bottom } = block.getBoundingRectangleWithoutChildren();
    pen.fillStyle = block.getColour();
    pen.fillRect(...this.placed(left, top, right - left, bottom - top));
  }

  private placed(x: number, y: number, width: number, height: number) {
    const { scale, origin } = this;
    return [
      PADDING + (x - origin.x) * scale,
      PADDING + (y - origin.y) * scale,
      Math.max(1, width * scale),
      Math.max(1, height * scale),
    ] as const;
  }

  private cleared(): CanvasRenderingContext2D | null {
    const sharp = window.devicePixelRatio || 1;
    this.canvas.width = WIDTH * sharp;
    this.canvas.height = HEIGHT * sharp;
    const pen = this.canvas.getContext("2d");
    pen?.scale(sharp, sharp);
    return pen;
  }

  private readonly onPointer = (event: PointerEvent): void => {
    if (event.type === "pointerdown") this.canvas.setPointerCapture(event.pointerId);
    else if (event.buttons === 0) return;
    const view = this.workspace.getMetricsManager().getViewMetrics(true);
    const x = this.origin.x + (event.offsetX - PADDING) / this.scale - view.width / 2;
    const y = this.origin.y + (event.offsetY - PADDING) / this.scale - view.height / 2;
    this.workspace.scroll(-x * this.workspace.scale, -y * this.workspace.scale);
    event.preventDefault();
  };
}
