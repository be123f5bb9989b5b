import {
  type BufferGeometry,
  CylinderGeometry,
  EdgesGeometry,
  ExtrudeGeometry,
  Group,
  LineSegments,
  type Material,
  Mesh,
  Shape,
  ShapeGeometry,
  SphereGeometry,
} from "three";
import { mergeGeometries } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import type { Robot, Wheel } from "../../api/model";
import type { Pose } from "../../run/reducer";
import type { Colours } from "../colours";
import { extentOf, hullCorners, onHull } from "../hull";
import type { Livery } from "../livery/livery";
import { mixed } from "../mat/parts";
import { coloured } from "./geometry";
import {
  type Atmosphere,
  disposeMaterials,
  type RobotMaterials,
  robotMaterials,
} from "./materials";

const SONAR = "#e9b949";
const BEVEL_PART = 0.06;

/** Heights of a robot, metres: records have none, so they follow from wheels and hull. */
export interface RobotHeights {
  readonly floor: number;
  readonly deck: number;
  readonly top: number;
  /** Height of its eye. */
  readonly eye: number;
}

export function heightsOf(robot: Robot): RobotHeights {
  const wheel = robot.wheels[0]?.radius_m ?? 0.3 * robot.radius_m;
  const deck = Math.max(2.05 * wheel, 0.55 * extentOf(robot).width);
  const top = 1.09 * deck;
  return { floor: 0.5 * wheel, deck, top, eye: top + 0.4 * robot.radius_m };
}

/** The colour of the robot's lamp by what it does. */
export type Lamp = "off" | "running" | "beeping";

/** A robot built from its record. Its wheels turn with the distance that they roll. */
export class RobotModel {
  readonly group = new Group();
  readonly heights: RobotHeights;
  private readonly materials: RobotMaterials;
  private readonly wheels: readonly (readonly [Mesh, Wheel])[];
  private readonly geometries: BufferGeometry[] = [];
  private pose: Pose | null = null;

  constructor(
    robot: Robot,
    private readonly colours: Colours,
    atmosphere: Atmosphere,
    livery: Livery | null = null,
    isGhost = false,
  ) {
    this.heights = heightsOf(robot);
    this.materials = robotMaterials(robot, livery, colours, atmosphere, isGhost);
    this.add(hullOf(robot, this.heights), this.materials.body);
    this.add(deckOf(robot, this.heights), this.materials.deck);
    this.add(arrowOf(robot, this.heights), this.materials.mark, false);
    this.add(partsOf(robot, this.heights, colours), this.materials.parts, false);
    this.add(lampOf(robot, this.heights), this.materials.lamp, false);
    this.wheels = robot.wheels.map((wheel) => {
      const mesh = this.add(wheelOf(wheel, colours), this.materials.parts, false);
      mesh.position.set(wheel.x_m, wheel.y_m, wheel.radius_m);
      return [mesh, wheel] as const;
    });
    this.shine("off");
  }

  /** Moves the robot in its start frame and rolls its wheels. */
  moveTo(pose: Pose): void {
    const { pose: before } = this;
    this.pose = pose;
    this.group.position.set(pose.x, pose.y, 0);
    this.group.rotation.z = pose.yaw;
    if (!before) return;
    for (const [mesh, wheel] of this.wheels) mesh.rotation.y += rolled(before, pose, wheel);
  }

  shine(lamp: Lamp): void {
    const { path, deck, mark } = this.colours;
    const colour = { off: mixed(deck, mark, 0.35), running: path, beeping: "#ffd23f" }[lamp];
    this.materials.lamp.color.set(colour);
  }

  dispose(): void {
    for (const geometry of this.geometries) geometry.dispose();
    disposeMaterials(this.materials);
    this.group.removeFromParent();
  }

  private add(geometry: BufferGeometry, material: Material, isOutlined = true): Mesh {
    const mesh = new Mesh(geometry, material);
    this.group.add(mesh);
    this.geometries.push(geometry);
    const { edge } = this.materials;
    if (edge && isOutlined) {
      const edges = new EdgesGeometry(geometry, 40);
      this.geometries.push(edges);
      this.group.add(new LineSegments(edges, edge));
    }
    return mesh;
  }
}

/** How far a wheel turns between two poses, radians, positive ahead. */
export function rolled(from: Pose, to: Pose, { x_m, y_m, radius_m }: Wheel): number {
  const heading = (from.yaw + to.yaw) / 2;
  const placed = ({ x, y, yaw }: Pose) => [
    x + x_m * Math.cos(yaw) - y_m * Math.sin(yaw),
    y + x_m * Math.sin(yaw) + y_m * Math.cos(yaw),
  ];
  const [[ax = 0, ay = 0], [bx = 0, by = 0]] = [placed(from), placed(to)];
  return ((bx - ax) * Math.cos(heading) + (by - ay) * Math.sin(heading)) / radius_m;
}

function hullOf(robot: Robot, { floor, deck }: RobotHeights): BufferGeometry {
  const shape = new Shape();
  hullCorners(robot).forEach(({ into, corner, out }, index) => {
    if (index === 0) shape.moveTo(into.x, into.y);
    else shape.lineTo(into.x, into.y);
    shape.quadraticCurveTo(corner.x, corner.y, out.x, out.y);
  });
  shape.closePath();
  return extruded(shape, deck - floor, BEVEL_PART * robot.radius_m).translate(0, 0, floor);
}

/** A plate with bevelled edges, inside its outline. */
function extruded(shape: Shape, height: number, bevel: number): BufferGeometry {
  return new ExtrudeGeometry(shape, {
    depth: height - 2 * bevel,
    bevelThickness: bevel,
    bevelSize: bevel,
    bevelOffset: -bevel,
    bevelSegments: 2,
    curveSegments: 4,
  }).translate(0, 0, bevel);
}

/** Deck and arrow at the same parts of the hull as in the drawing from above (`robot.ts`). */
function deckOf(robot: Robot, { deck, top }: RobotHeights): BufferGeometry {
  const { back, length, width } = extentOf(robot);
  const [left, right, half] = [back + 0.15 * length, back + 0.72 * length, 0.31 * width];
  const r = 0.19 * width;
  const shape = new Shape();
  shape.moveTo(left + r, -half);
  shape.lineTo(right - r, -half);
  shape.absarc(right - r, -half + r, r, -Math.PI / 2, 0);
  shape.absarc(right - r, half - r, r, 0, Math.PI / 2);
  shape.absarc(left + r, half - r, r, Math.PI / 2, Math.PI);
  shape.absarc(left + r, -half + r, r, Math.PI, 1.5 * Math.PI);
  const height = top - deck;
  return extruded(shape, height, 0.3 * height).translate(0, 0, deck);
}

function arrowOf(robot: Robot, { top }: RobotHeights): BufferGeometry {
  const { back, length, width } = extentOf(robot);
  const x = (part: number) => back + part * length;
  const shape = new Shape();
  shape.moveTo(x(0.69), 0);
  shape.lineTo(x(0.35), 0.26 * width);
  shape.lineTo(x(0.42), 0);
  shape.lineTo(x(0.35), -0.26 * width);
  return new ShapeGeometry(shape).translate(0, 0, top + 0.002);
}

/** Sonars on the hull, the laser scanner on the deck and the caster below. */
function partsOf(robot: Robot, heights: RobotHeights, colours: Colours): BufferGeometry {
  const { deck, floor } = heights;
  const r = 0.07 * robot.radius_m;
  const sonars = robot.sonars.map(({ x_m, y_m, angle_rad }) => {
    const { x, y } = onHull(robot, { x: x_m, y: y_m });
    const sonar = new CylinderGeometry(r, r, 0.5 * r, 12).rotateZ(Math.PI / 2).rotateZ(angle_rad);
    return coloured(sonar.translate(x, y, floor + 0.72 * (deck - floor)), SONAR);
  });
  const merged = mergeGeometries([
    ...sonars,
    ...laserOf(robot, heights, colours),
    casterOf(robot, heights, colours),
  ]);
  return merged;
}

function laserOf(
  { laser, radius_m }: Robot,
  { top }: RobotHeights,
  colours: Colours,
): BufferGeometry[] {
  if (!laser) return [];
  const layer = (r: number, z: number, height: number, fill: string) =>
    coloured(
      new CylinderGeometry(r, r, height, 20)
        .rotateX(Math.PI / 2)
        .translate(laser.x_m, laser.y_m, top + z + height / 2),
      fill,
    );
  const r = 0.14 * radius_m;
  return [
    layer(r, 0, 0.5 * r, colours.deck),
    layer(0.94 * r, 0.5 * r, 0.35 * r, colours.start),
    layer(r, 0.85 * r, 0.25 * r, colours.deck),
  ];
}

/** The wheel that only supports, where the driven ones do not. */
function casterOf(robot: Robot, { floor }: RobotHeights, colours: Colours): BufferGeometry {
  const { back, front } = extentOf(robot);
  const wheelX = robot.wheels[0]?.x_m ?? 0;
  const x = wheelX - back > front - wheelX ? 0.75 * back : 0.75 * front;
  const r = 0.6 * floor;
  const caster = new CylinderGeometry(r, r, 0.8 * r, 14).translate(x, 0, r);
  return coloured(caster, colours.wheel);
}

function lampOf(robot: Robot, { top }: RobotHeights): BufferGeometry {
  const { back, length } = extentOf(robot);
  const r = 0.1 * robot.radius_m;
  return new SphereGeometry(r, 14, 8).translate(back + 0.24 * length, 0, top + 0.4 * r);
}

/** A tyre with a bright hub; the dark spokes show that it turns. */
function wheelOf({ radius_m: r, width_m: width }: Wheel, colours: Colours): BufferGeometry {
  const disc = (radius: number, wide: number, fill: string) =>
    coloured(new CylinderGeometry(radius, radius, wide, 24), fill);
  const rim = mixed(colours.wheel, "#ffffff", 0.72);
  const spokes = [0, 1, 2].map((index) => {
    const spoke = new CylinderGeometry(0.09 * r, 0.09 * r, 1.08 * width, 6);
    const angle = (index * 2 * Math.PI) / 3;
    return coloured(
      spoke.translate(0.34 * r * Math.cos(angle), 0, 0.34 * r * Math.sin(angle)),
      colours.wheel,
    );
  });
  return mergeGeometries([
    disc(r, width, colours.wheel),
    disc(0.62 * r, 1.05 * width, rim),
    ...spokes,
  ]);
}
