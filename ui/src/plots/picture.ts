import { CATEGORY_COLOURS, type Category } from "../blocks/categories";
import { categoryOf } from "../blocks/definitions";
import type { Language, Texts } from "../i18n";
import type { Stretch } from "../run/playback";
import type { Samples } from "../run/samples";
import { chartOf, titlesOf } from "./ChartBox";
import type { FigureName } from "./figures";
import { categoryWords, type Entry, entriesOf } from "./Legend";
import { DASHES, type Look, paperLook, WIDTHS } from "./look";

/** Sizes of the picture in CSS pixels; the device's pixel ratio multiplies them. */
const WIDTH = 1000;
const CHART = 560;
const HEAD = 72;
const LEGEND = 34;
const MARGIN = 16;

interface About {
  readonly figure: FigureName;
  readonly name: string;
  readonly texts: Texts;
  readonly language: Language;
}

/** Renders a plot on a white background with title and legend, as a PNG for reports. */
export async function pictureOf(
  samples: Samples,
  stretches: readonly Stretch[],
  about: About,
): Promise<Blob | null> {
  const look = paperLook();
  const chart = await chartCanvas(samples, stretches, about, look);
  const scale = chart.width / (WIDTH - 2 * MARGIN);
  const canvas = document.createElement("canvas");
  const legends = about.figure === "path" ? 1 : 2;
  canvas.width = Math.round(WIDTH * scale);
  canvas.height = Math.round((HEAD + CHART + legends * LEGEND + MARGIN) * scale);
  const ctx = canvas.getContext("2d");
  if (!ctx) return null;
  ctx.fillStyle = look.ground;
  ctx.fillRect(0, 0, canvas.width, canvas.height);
  ctx.drawImage(chart, MARGIN * scale, HEAD * scale);
  ctx.scale(scale, scale);
  drawTitle(ctx, about, look);
  const entries = entriesOf(about.figure, samples, about.texts, about.language);
  drawLines(ctx, entries, HEAD + CHART + LEGEND / 2, look);
  if (legends > 1) drawBlocks(ctx, stretches, about, HEAD + CHART + 1.5 * LEGEND, look);
  return new Promise((done) => canvas.toBlob(done, "image/png"));
}

const IDLE_HAND = { onPoint() {}, onPress() {} };

/** Renders a chart that is not in the page. */
async function chartCanvas(
  samples: Samples,
  stretches: readonly Stretch[],
  { figure, texts, language }: About,
  look: Look,
): Promise<HTMLCanvasElement> {
  const size = { width: WIDTH - 2 * MARGIN, height: CHART };
  const setting = { look, language, titles: titlesOf(figure, texts), ...size };
  const chart = chartOf(figure, setting, document.createElement("div"), IDLE_HAND);
  // uPlot draws in a microtask; the path plot first requests its size
  await settled();
  chart.show(samples, stretches);
  await settled();
  return chart.plot.ctx.canvas;
}

const settled = () => new Promise((done) => setTimeout(done));

function drawTitle(ctx: CanvasRenderingContext2D, about: About, look: Look): void {
  const { figure, name, texts, language } = about;
  ctx.fillStyle = look.ink;
  ctx.textAlign = "left";
  ctx.textBaseline = "alphabetic";
  ctx.font = `700 22px ${look.font}`;
  ctx.fillText(texts.plots.titles[figure], MARGIN, 34);
  const day = new Date().toLocaleDateString(language, { dateStyle: "long" });
  ctx.font = `400 15px ${look.font}`;
  ctx.fillText([name, day, "PINEL"].filter(Boolean).join(" · "), MARGIN, 58);
}

function drawLines(
  ctx: CanvasRenderingContext2D,
  entries: readonly Entry[],
  y: number,
  look: Look,
): void {
  let x = MARGIN;
  ctx.font = `500 15px ${look.font}`;
  ctx.textBaseline = "middle";
  for (const { role, ink, name } of entries) {
    ctx.strokeStyle = look[ink];
    ctx.lineWidth = WIDTHS[role];
    ctx.setLineDash([...DASHES[role]]);
    ctx.beginPath();
    ctx.moveTo(x, y);
    ctx.lineTo(x + 36, y);
    ctx.stroke();
    ctx.fillText(name, x + 44, y);
    x += 68 + ctx.measureText(name).width;
  }
}

/** Draws the categories of the blocks that ran, by colour. */
function drawBlocks(
  ctx: CanvasRenderingContext2D,
  stretches: readonly Stretch[],
  { language }: About,
  y: number,
  look: Look,
): void {
  const ran = new Set<Category>(stretches.map(({ action }) => categoryOf(action)));
  let x = MARGIN;
  for (const category of ran) {
    const words = categoryWords(category, language);
    ctx.fillStyle = CATEGORY_COLOURS[category];
    ctx.fillRect(x, y - 6, 36, 12);
    ctx.fillStyle = look.ink;
    ctx.fillText(words, x + 44, y);
    x += 68 + ctx.measureText(words).width;
  }
}
