import {
  CanvasTexture,
  type PerspectiveCamera,
  Sprite,
  SpriteMaterial,
  SRGBColorSpace,
} from "three";
import type { World } from "../../api/model";
import { areaOf } from "../areas";
import type { Colours } from "../colours";
import { isPictured, translationOf } from "../mat/places";

/** Height of the letters of a picture of text, in its pixels. */
const LETTERS_PX = 44;
const PAD_PX = 22;

interface Plate {
  readonly ink: string;
  readonly ground: string;
  readonly edge: string;
  readonly font: string;
}

/** A plate with a text that faces the camera and has one size at any distance, its lower edge at its place. */
export function labelSprite(text: string, plate: Plate): Sprite {
  const canvas = document.createElement("canvas");
  const ctx = canvas.getContext("2d");
  if (ctx) drawPlate(ctx, text, plate);
  const map = new CanvasTexture(canvas);
  map.colorSpace = SRGBColorSpace;
  const material = new SpriteMaterial({
    map,
    transparent: true,
    depthWrite: false,
    sizeAttenuation: false,
  });
  const sprite = new Sprite(material);
  sprite.center.set(0.5, 0);
  sprite.renderOrder = 20;
  sprite.userData = { aspect: canvas.width / canvas.height };
  return sprite;
}

/** Sets the height of a label, in metres at one metre before the camera. */
export function sizeLabel(sprite: Sprite, height: number): void {
  sprite.scale.set(height * Number(sprite.userData.aspect), height, 1);
}

function drawPlate(
  ctx: CanvasRenderingContext2D,
  text: string,
  { ink, ground, edge, font }: Plate,
): void {
  const { canvas } = ctx;
  const style = `700 ${LETTERS_PX}px ${font}`;
  ctx.font = style;
  canvas.width = Math.ceil(ctx.measureText(text).width) + 2 * PAD_PX;
  canvas.height = Math.round(1.5 * LETTERS_PX);
  const { width, height } = canvas;
  ctx.beginPath();
  ctx.roundRect(2, 2, width - 4, height - 4, height / 2);
  ctx.fillStyle = ground;
  ctx.fill();
  ctx.strokeStyle = edge;
  ctx.lineWidth = 3;
  ctx.stroke();
  ctx.font = style; // a canvas of another size starts anew
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  ctx.fillStyle = ink;
  ctx.fillText(text, width / 2, height / 2 + 2);
}

export function disposeSprite(sprite: Sprite): void {
  sprite.material.map?.dispose();
  sprite.material.dispose();
  sprite.removeFromParent();
}

const NAME_PX = 21;
/** Names float over the floor, so that a robot does not drive through the letters. */
const FLOAT_M = 0.03;

/** The names of all places: over the middle, or behind the field if a pictogram is on it. */
export function placeNames(world: World, colours: Colours): Sprite[] {
  const plate = { ink: colours.ink, ground: colours.tile, edge: colours.line, font: colours.font };
  return (world.zones ?? []).map((zone) => {
    const translation = translationOf(zone.name);
    const text = translation ? `${zone.name} · ${translation}` : zone.name;
    const sprite = labelSprite(text, plate);
    const { x, y, depth } = areaOf(zone);
    sprite.position.set(x, isPictured(world, zone) ? y + depth / 2 : y, FLOAT_M);
    return sprite;
  });
}

/** Gap between two names that would cover each other, as a part of their height. */
const GAP = 1.12;
/** Names are raised by so many lines at most. */
const MAX_LINES = 3;

/**
 * Gives names a size in pixels, and raises a name that would cover another one. `pixel` is the size of a pixel at one
 * metre before the camera.
 */
export function arrangeNames(
  names: readonly Sprite[],
  camera: PerspectiveCamera,
  pixel: number,
): void {
  const height = (2 * NAME_PX * pixel) / (2 * Math.tan((camera.fov * Math.PI) / 360));
  const placed: { x: number; y: number; half: number }[] = [];
  for (const name of names) {
    sizeLabel(name, NAME_PX * pixel);
    const { x, y, z } = name.position.clone().project(camera);
    if (z > 1) continue; // behind the camera
    const half = (height * Number(name.userData.aspect)) / camera.aspect / 2;
    const covers = (line: number) =>
      placed.some(
        (other) =>
          Math.abs(other.x - x) < other.half + half &&
          Math.abs(other.y - y - line * GAP * height) < height,
      );
    let line = 0;
    while (line < MAX_LINES && covers(line)) line++;
    name.center.y = -line * GAP;
    const raised = y + line * GAP * height;
    // a name that is raised out of the picture could not be read
    name.visible = line === 0 || raised + height <= 1;
    placed.push({ x, y: raised, half });
  }
}
