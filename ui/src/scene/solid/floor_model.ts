import {
  CanvasTexture,
  EdgesGeometry,
  Group,
  LineBasicMaterial,
  LineSegments,
  type Material,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  type PerspectiveCamera,
  PlaneGeometry,
  type Sprite,
  SRGBColorSpace,
} from "three";
import type { Robot, World } from "../../api/model";
import type { BoxPoses } from "../../run/reducer";
import { areaOf, WALL_M } from "../areas";
import type { Colours } from "../colours";
import { roomOf } from "../frames";
import { bodyInk } from "../mat/draw";
import { mixed } from "../mat/parts";
import { BOX_SOLIDS, chestOf, crateOf, type Solid, wallOf } from "../mat/solids";
import { drawGroundTexture } from "./floor_texture";
import { geometryOf, type Place } from "./geometry";
import { arrangeNames, disposeSprite, placeNames } from "./labels";
import type { Atmosphere } from "./materials";
import type { Quality } from "./quality";
import { Shadow } from "./shadow";

type Box = World["boxes"][number];

/** Thickness of the mat below the floor, and how far it reaches out of the room. */
const MAT_M = 0.07;
const RIM_M = WALL_M;

/** The room: the floor with all that is printed on it, walls, boxes and the names of places. */
export class FloorModel {
  readonly group = new Group();
  private readonly texture: CanvasTexture;
  private readonly material: MeshLambertMaterial;
  private readonly edge: LineBasicMaterial | null;
  private readonly movable = new Map<number, Mesh>();
  private readonly shadows: Shadow[] = [];
  private readonly names: Sprite[];
  private readonly others: { dispose(): void }[] = [];

  constructor(
    private readonly world: World | null,
    robot: Robot | null,
    private readonly colours: Colours,
    { isOutlined }: Atmosphere,
    { floor: [size, anisotropy] }: Quality,
  ) {
    this.texture = new CanvasTexture(drawGroundTexture(world, robot, colours, size));
    this.texture.colorSpace = SRGBColorSpace;
    this.texture.anisotropy = anisotropy;
    this.material = new MeshLambertMaterial({ vertexColors: true });
    this.edge = isOutlined ? new LineBasicMaterial({ color: colours.boxSide }) : null;
    this.addGround();
    this.addBody([...this.walls(), ...this.fixedBoxes()]);
    this.addMovableBoxes(isOutlined);
    this.names = world ? placeNames(world, colours) : [];
    for (const name of this.names) this.group.add(name);
  }

  /** `pixel` is the size of a pixel at one metre before the camera. */
  arrangeNames(camera: PerspectiveCamera, pixel: number): void {
    arrangeNames(this.names, camera, pixel);
  }

  /** Moves pushed boxes; a box without a pose is where the world has it. */
  moveBoxes(poses: BoxPoses): void {
    for (const [index, mesh] of this.movable) {
      const [x, y, yaw] = poses[index] ?? [];
      const box = this.world?.boxes[index];
      const at =
        x === undefined || y === undefined || yaw === undefined
          ? box && placeOf(box)
          : { x, y, yaw };
      if (!at) continue;
      mesh.position.set(at.x, at.y, 0);
      mesh.rotation.z = at.yaw;
    }
    for (const shadow of this.shadows) shadow.follow();
  }

  showShadows(isShown: boolean): void {
    for (const { mesh } of this.shadows) mesh.visible = isShown;
  }

  dispose(): void {
    this.texture.dispose();
    this.material.dispose();
    this.edge?.dispose();
    for (const one of [...this.others, ...this.shadows]) one.dispose();
    for (const name of this.names) disposeSprite(name);
    this.group.removeFromParent();
  }

  private addGround(): void {
    const { left, right, bottom, top } = roomOf(this.world);
    const [width, depth] = [right - left, top - bottom];
    const plane = new Mesh(
      new PlaneGeometry(width, depth),
      new MeshBasicMaterial({ map: this.texture }),
    );
    plane.renderOrder = -1;
    this.group.add(plane);
    this.others.push(plane.geometry, plane.material);
    const size = [width + 2 * RIM_M, depth + 2 * RIM_M, MAT_M] as const;
    const rim: Solid = { form: "block", at: [0, 0, -MAT_M - 0.004], size, fill: this.wallColour };
    this.addBody([[{ x: 0, y: 0, yaw: 0 }, this.inked([rim])]]);
  }

  /** Walls are lighter than lines: they cover more of the picture. */
  private get wallColour(): string {
    return mixed(this.colours.wall, this.colours.box, 0.42);
  }

  private walls(): (readonly [Place, Solid[]])[] {
    return (this.world?.walls ?? []).map(({ from: [ax = 0, ay = 0], to: [bx = 0, by = 0] }) => {
      const place = { x: (ax + bx) / 2, y: (ay + by) / 2, yaw: Math.atan2(by - ay, bx - ax) };
      const length = Math.hypot(bx - ax, by - ay) + WALL_M;
      return [place, this.inked(wallOf(this.wallColour)(length, WALL_M))] as const;
    });
  }

  private fixedBoxes(): (readonly [Place, Solid[]])[] {
    const boxes = (this.world?.boxes ?? []).filter(({ movable }) => !movable);
    return boxes.map((box) => [placeOf(box), this.bodiesOf(box)] as const);
  }

  private addMovableBoxes(isOutlined: boolean): void {
    this.world?.boxes.forEach((box, index) => {
      if (!box.movable) return;
      const mesh = this.addBody([[{ x: 0, y: 0, yaw: 0 }, this.bodiesOf(box)]]);
      this.movable.set(index, mesh);
      if (isOutlined) return;
      const { width, depth } = areaOf(box);
      this.shadows.push(new Shadow(mesh, [width, depth], this.colours));
    });
    for (const { mesh } of this.shadows) this.group.add(mesh);
    this.moveBoxes({});
  }

  private bodiesOf(box: Box): Solid[] {
    const { width, depth } = areaOf(box);
    const { box: fill, boxSide } = this.colours;
    const plain = box.movable ? crateOf(fill, boxSide) : chestOf(fill, boxSide);
    if (!box.kind) return this.inked(plain(width, depth), (colour) => colour);
    return this.inked(BOX_SOLIDS[box.kind](width, depth), bodyInk(this.colours));
  }

  /** Gives bodies the colours of the theme: one dark colour for all in high contrast, where outlines show them. */
  private inked(
    solids: Solid[],
    ink: ((colour: string) => string) | null = (colour) => colour,
  ): Solid[] {
    const { box, print } = this.colours;
    const isPlain = !Number(print);
    return solids.map((solid) => ({ ...solid, fill: isPlain || !ink ? box : ink(solid.fill) }));
  }

  private addBody(parts: readonly (readonly [Place, readonly Solid[]])[]): Mesh {
    const mesh = new Mesh(geometryOf(parts), this.material as Material);
    this.others.push(mesh.geometry);
    this.group.add(mesh);
    if (this.edge && parts.length > 0) {
      const edges = new EdgesGeometry(mesh.geometry, 30);
      this.others.push(edges);
      mesh.add(new LineSegments(edges, this.edge));
    }
    return mesh;
  }
}

function placeOf(box: Box): Place {
  const { x, y, heading } = areaOf(box);
  return { x, y, yaw: (heading * Math.PI) / 180 };
}
