import { CanvasTexture, Mesh, MeshBasicMaterial, type Object3D, PlaneGeometry } from "three";
import type { Colours } from "../colours";

const SIZE_PX = 64;
/** Part of the picture that is full; the rest fades out. */
const FULL_PART = 0.62;
const FALL_M = [0.04, -0.06] as const;

/** A soft spot below something that moves: as a shadow of three.js costs a second picture of the scene. */
export class Shadow {
  readonly mesh: Mesh<PlaneGeometry, MeshBasicMaterial>;
  private readonly map: CanvasTexture;

  constructor(
    private readonly above: Object3D,
    size: readonly [length: number, width: number],
    { shadow }: Colours,
  ) {
    this.map = new CanvasTexture(spot(shadow));
    const material = new MeshBasicMaterial({ map: this.map, transparent: true, depthWrite: false });
    const [length, width] = size.map((side) => side / FULL_PART);
    this.mesh = new Mesh(new PlaneGeometry(length, width), material);
    this.mesh.renderOrder = 9;
  }

  follow(): void {
    const { position, rotation } = this.above;
    this.mesh.position.set(position.x + FALL_M[0], position.y + FALL_M[1], 0.009);
    this.mesh.rotation.z = rotation.z;
  }

  dispose(): void {
    this.map.dispose();
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
    this.mesh.removeFromParent();
  }
}

function spot(colour: string): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  canvas.width = SIZE_PX;
  canvas.height = SIZE_PX;
  const ctx = canvas.getContext("2d");
  if (!ctx) return canvas;
  const soft = (SIZE_PX * (1 - FULL_PART)) / 2;
  ctx.shadowColor = colour;
  ctx.shadowBlur = soft;
  // drawn outside of the picture, so that only its shadow is on it
  ctx.shadowOffsetX = SIZE_PX;
  ctx.fillStyle = "#000000";
  ctx.beginPath();
  ctx.roundRect(soft - SIZE_PX, soft, SIZE_PX - 2 * soft, SIZE_PX - 2 * soft, 6);
  ctx.fill();
  return canvas;
}
