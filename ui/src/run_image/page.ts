import type { DrawnBlock, DrawnStack } from "../editor/reader/program_drawing";
import type { Colours } from "../scene/colours";
import type { Size } from "../scene/framing/viewport";
import { type Columns, columnsOf } from "./columns";

/** Sizes of a page, in pixels of the page; a canvas has `ratio` pixels for each. */
export interface PageFormat {
  readonly ratio: number;
  readonly floorWidth: number;
  readonly blocksWidth: number;
  readonly margin: number;
  /** Height of the title and the lines below it. */
  readonly head: number;
  readonly titlePx: number;
  readonly textPx: number;
  readonly minScale: number;
}

/** A picture to print: an A4 in landscape, at 200 dots an inch. */
export const PRINT_FORMAT: PageFormat = {
  ratio: 2,
  floorWidth: 640,
  blocksWidth: 416,
  margin: 24,
  head: 92,
  titlePx: 28,
  textPx: 17,
  minScale: 0.55,
};

/** A frame of an animation, for a screen. */
export const FRAME_FORMAT: PageFormat = {
  ratio: 1,
  floorWidth: 480,
  blocksWidth: 340,
  margin: 14,
  head: 62,
  titlePx: 20,
  textPx: 14,
  minScale: 0.5,
};

/** What stands above the floor; `owner` and `facts` at the right. */
export interface PageTexts {
  readonly title: string;
  readonly mission: string;
  readonly owner: string;
  readonly facts: string;
}

const PAPER = "#ffffff";
const MAX_SCALE = 0.9;
/** Share of the width that the texts at the right may have; those at the left have the rest. */
const RIGHT_PART = 0.6;

/** A page on white paper: the texts, the floor, and the blocks of the program beside it. */
export class Page {
  readonly canvas = document.createElement("canvas");
  private readonly ctx = contextOf(this.canvas);
  /** Everything but the floor and the mark of the running block. */
  private readonly still = document.createElement("canvas");
  private readonly blocks: Columns<DrawnBlock>;

  constructor(
    private readonly format: PageFormat,
    texts: PageTexts,
    private readonly floor: Size,
    stacks: readonly DrawnStack[],
    private readonly colours: Colours,
  ) {
    const { ratio, margin, head, floorWidth, blocksWidth, minScale } = format;
    const area = { width: blocksWidth, height: floorWidth, maxScale: MAX_SCALE, minScale };
    this.blocks = columnsOf(stacks, area);
    const right = stacks.length > 0 ? margin + blocksWidth + margin : margin;
    const height = head + Math.max(floor.height, this.blocks.height) + margin;
    this.canvas.width = Math.round((margin + floorWidth + right) * ratio);
    this.canvas.height = Math.round(height * ratio);
    this.still.width = this.canvas.width;
    this.still.height = this.canvas.height;
    this.drawStill(contextOf(this.still), texts);
  }

  /** Draws the page with a floor; marks the running block. `speed` stands on the floor if it is not 1. */
  draw(floor: HTMLCanvasElement, running: string | null = null, speed = 1): void {
    const { ctx, format, colours } = this;
    const { margin, head } = format;
    const { width, height } = this.floor;
    ctx.setTransform(1, 0, 0, 1, 0, 0);
    ctx.drawImage(this.still, 0, 0);
    ctx.scale(format.ratio, format.ratio);
    ctx.drawImage(floor, margin, head, width, height);
    ctx.strokeStyle = colours.wall;
    ctx.lineWidth = 1;
    ctx.strokeRect(margin + 0.5, head + 0.5, width - 1, height - 1);
    if (running !== null) this.paintBlocks(ctx, (block) => block.has(running), running);
    if (speed !== 1) this.drawSpeed(speed);
  }

  get pixels(): ImageData {
    return this.ctx.getImageData(0, 0, this.canvas.width, this.canvas.height);
  }

  private drawStill(ctx: CanvasRenderingContext2D, texts: PageTexts): void {
    const { width, height } = this.still;
    const { ratio } = this.format;
    ctx.fillStyle = PAPER;
    ctx.fillRect(0, 0, width, height);
    ctx.scale(ratio, ratio);
    this.drawTexts(ctx, texts, width / ratio);
    this.paintBlocks(ctx, () => true, null);
  }

  private drawTexts(ctx: CanvasRenderingContext2D, texts: PageTexts, width: number): void {
    const { margin, head, titlePx, textPx } = this.format;
    const { ink, number, font } = this.colours;
    const whole = width - 2 * margin;
    /** Writes a text, as far as it has room; returns how wide it is. */
    const write = (text: string, y: number, max: number, weight: number, px: number) => {
      ctx.font = `${weight} ${px}px ${font}`;
      const x = ctx.textAlign === "right" ? width - margin : margin;
      const written = shortened(ctx, text, max);
      ctx.fillText(written, x, y);
      return ctx.measureText(written).width;
    };
    const [first, second] = [head * 0.32, head * 0.7];
    ctx.textBaseline = "middle";
    ctx.textAlign = "right";
    ctx.fillStyle = ink;
    const owner = write(texts.owner, first, whole * RIGHT_PART, 600, textPx + 2);
    ctx.fillStyle = number;
    const facts = write(texts.facts, second, whole * RIGHT_PART, 400, textPx - 2);
    ctx.textAlign = "left";
    ctx.fillStyle = ink;
    write(texts.title, first, whole - owner - margin, 700, titlePx);
    write(texts.mission, second, whole - facts - margin, 600, textPx);
  }

  private paintBlocks(
    ctx: CanvasRenderingContext2D,
    isPainted: (block: DrawnBlock) => boolean,
    running: string | null,
  ): void {
    const { margin, head, floorWidth } = this.format;
    const { placed, scale } = this.blocks;
    for (const { block, x, y } of placed.filter((one) => isPainted(one.block))) {
      ctx.save();
      ctx.translate(2 * margin + floorWidth + x, head + y);
      ctx.scale(scale, scale);
      block.paint(ctx, running);
      ctx.restore();
    }
  }

  /** Says at the upper right corner of the floor that the animation is faster than the run. */
  private drawSpeed(speed: number): void {
    const { ctx, colours, format } = this;
    const { margin, head, floorWidth, textPx } = format;
    const [width, height] = [3.4 * textPx, 1.8 * textPx];
    const [left, top] = [margin + floorWidth - width - 10, head + 10];
    ctx.fillStyle = colours.ink;
    ctx.beginPath();
    ctx.roundRect(left, top, width, height, height / 2);
    ctx.fill();
    ctx.fillStyle = PAPER;
    ctx.font = `700 ${textPx}px ${colours.font}`;
    ctx.textAlign = "center";
    ctx.textBaseline = "middle";
    ctx.fillText(`${speed}×`, left + width / 2, top + height / 2);
  }
}

function contextOf(canvas: HTMLCanvasElement): CanvasRenderingContext2D {
  const ctx = canvas.getContext("2d", { willReadFrequently: true });
  if (!ctx) throw new Error("no 2D canvas");
  return ctx;
}

/** The text, or its beginning with an ellipsis if it is wider than `max`. */
function shortened(ctx: CanvasRenderingContext2D, text: string, max: number): string {
  if (ctx.measureText(text).width <= max) return text;
  let end = text.length;
  while (end > 0 && ctx.measureText(`${text.slice(0, end)}…`).width > max) end--;
  return `${text.slice(0, end).trimEnd()}…`;
}
