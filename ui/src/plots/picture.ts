import { CATEGORY_COLOURS, type Category } from "../blocks/categories";
import { categoryOf } from "../blocks/definitions";
import type { Language, Texts } from "../i18n";
import type { Stretch } from "../run/playback";
import type { Samples } from "../run/samples";
import { chartOf, titlesOf } from "./ChartBox";
import { categoryLabel, entriesOf, type LegendEntry } from "./Legend";
import { DASHES, type PlotStyle, paperStyle, WIDTHS } from "./plot_style";
import type { PlotName } from "./plots";

/** Sizes of the picture in CSS pixels; the device's pixel ratio multiplies them. */
const WIDTH = 1000;
const CHART = 560;
const HEAD = 72;
const LEGEND = 34;
const MARGIN = 16;

interface About {
  readonly plotName: PlotName;
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
  const style = paperStyle();
  const chart = await chartCanvas(samples, stretches, about, style);
  const scale = chart.width / (WIDTH - 2 * MARGIN);
  const canvas = document.createElement("canvas");
  const legends = about.plotName === "path" ? 1 : 2;
  canvas.width = Math.round(WIDTH * scale);
  canvas.height = Math.round((HEAD + CHART + legends * LEGEND + MARGIN) * scale);
  const ctx = canvas.getContext("2d");
  if (!ctx) return null;
  ctx.fillStyle = style.ground;
  ctx.fillRect(0, 0, canvas.width, canvas.height);
  ctx.drawImage(chart, MARGIN * scale, HEAD * scale);
  ctx.scale(scale, scale);
  drawTitle(ctx, about, style);
  const entries = entriesOf(about.plotName, samples, about.texts, about.language);
  drawLines(ctx, entries, HEAD + CHART + LEGEND / 2, style);
  if (legends > 1) drawBlocks(ctx, stretches, about, HEAD + CHART + 1.5 * LEGEND, style);
  return new Promise((done) => canvas.toBlob(done, "image/png"));
}

const IDLE_HAND = { onPoint() {}, onPress() {} };

/** Renders a chart that is not in the page. */
async function chartCanvas(
  samples: Samples,
  stretches: readonly Stretch[],
  { plotName, texts, language }: About,
  style: PlotStyle,
): Promise<HTMLCanvasElement> {
  const size = { width: WIDTH - 2 * MARGIN, height: CHART };
  const chartOptions = { style, language, titles: titlesOf(plotName, texts), ...size };
  const chart = chartOf(plotName, chartOptions, document.createElement("div"), IDLE_HAND);
  // uPlot draws in a microtask; the path plot first requests its size
  await settled();
  chart.show(samples, stretches);
  await settled();
  return chart.plot.ctx.canvas;
}

const settled = () => new Promise((done) => setTimeout(done));

function drawTitle(ctx: CanvasRenderingContext2D, about: About, style: PlotStyle): void {
  const { plotName, name, texts, language } = about;
  ctx.fillStyle = style.ink;
  ctx.textAlign = "left";
  ctx.textBaseline = "alphabetic";
  ctx.font = `700 22px ${style.font}`;
  ctx.fillText(texts.plots.titles[plotName], MARGIN, 34);
  const day = new Date().toLocaleDateString(language, { dateStyle: "long" });
  ctx.font = `400 15px ${style.font}`;
  ctx.fillText([name, day, "PINEL"].filter(Boolean).join(" · "), MARGIN, 58);
}

function drawLines(
  ctx: CanvasRenderingContext2D,
  entries: readonly LegendEntry[],
  y: number,
  style: PlotStyle,
): void {
  let x = MARGIN;
  ctx.font = `500 15px ${style.font}`;
  ctx.textBaseline = "middle";
  for (const { role, ink, name } of entries) {
    ctx.strokeStyle = style[ink];
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
  style: PlotStyle,
): void {
  const ran = new Set<Category>(stretches.map(({ action }) => categoryOf(action)));
  let x = MARGIN;
  for (const category of ran) {
    const label = categoryLabel(category, language);
    ctx.fillStyle = CATEGORY_COLOURS[category];
    ctx.fillRect(x, y - 6, 36, 12);
    ctx.fillStyle = style.ink;
    ctx.fillText(label, x + 44, y);
    x += 68 + ctx.measureText(label).width;
  }
}
