import { fileName, saveFile } from "../shell/files/save_file";
import { type Colours, paperColours } from "./colours";
import type { Size } from "./framing/viewport";

const WIDTH = 800;
const HEIGHT = 640;
const HEAD = 56;
/** Twice the resolution, for print. */
const RATIO = 2;

/** A floor that can be drawn for export, at `ratio` pixels for each of its size. */
export interface Pictured {
  picture(size: Size, ratio: number, colours: Colours): HTMLCanvasElement;
}

/** Downloads the floor with path and drawings as a PNG on a white background, named after the program. */
export async function savePicture(scene: Pictured, name: string): Promise<void> {
  const colours = paperColours();
  const floor = scene.picture({ width: WIDTH, height: HEIGHT }, RATIO, colours);
  const canvas = document.createElement("canvas");
  canvas.width = WIDTH * RATIO;
  canvas.height = (HEIGHT + HEAD) * RATIO;
  const ctx = canvas.getContext("2d");
  if (!ctx) return;
  ctx.fillStyle = "#ffffff";
  ctx.fillRect(0, 0, canvas.width, canvas.height);
  ctx.drawImage(floor, 0, HEAD * RATIO);
  ctx.scale(RATIO, RATIO);
  ctx.fillStyle = "#211f1b";
  ctx.textBaseline = "middle";
  ctx.font = `700 24px ${colours.font}`;
  ctx.fillText(name, 16, HEAD / 2, WIDTH - 120);
  ctx.font = `600 15px ${colours.font}`;
  ctx.textAlign = "right";
  ctx.fillText("PINEL", WIDTH - 16, HEAD / 2);
  const image = await new Promise<Blob | null>((done) => canvas.toBlob(done, "image/png"));
  if (image) saveFile(`${fileName(name, "pinel")}.png`, image);
}
