import { CanvasTexture, SRGBColorSpace } from "three";
import type { Robot } from "../../api/model";
import { type LiveryPaint, patternFrame } from "../livery/livery";

const SIDE_PX = 256;

/** The hull's picture: the body with the pattern of its livery, over the square of `patternFrame`; null for a plain hull. */
export function liveryTexture(robot: Robot, { body, pattern }: LiveryPaint): CanvasTexture | null {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = SIDE_PX;
  const ctx = pattern && canvas.getContext("2d");
  if (!ctx) return null;
  const { drawing, colour } = pattern;
  ctx.fillStyle = body;
  ctx.fillRect(0, 0, SIDE_PX, SIDE_PX);
  ctx.translate(SIDE_PX / 2, SIDE_PX / 2);
  ctx.scale(SIDE_PX / 2, -SIDE_PX / 2);
  const shape = new Path2D(drawing.path);
  if (drawing.line) {
    ctx.strokeStyle = colour;
    ctx.lineWidth = drawing.line;
    ctx.stroke(shape);
  } else {
    ctx.fillStyle = colour;
    ctx.fill(shape);
  }
  return placed(new CanvasTexture(canvas), robot);
}

/** The hull's texture coordinates are metres in the robot's frame. */
function placed(texture: CanvasTexture, robot: Robot): CanvasTexture {
  const { x, unit } = patternFrame(robot);
  texture.colorSpace = SRGBColorSpace;
  texture.repeat.set(0.5 / unit, 0.5 / unit);
  texture.offset.set(0.5 - (0.5 * x) / unit, 0.5);
  return texture;
}
