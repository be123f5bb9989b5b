import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  Group,
  Mesh,
  MeshBasicMaterial,
} from "three";
import type { Robot } from "../../api/model";
import type { Colours } from "../colours";
import { CONE_DEG, FAR_M, type Measurements } from "../ranges_view";
import type { RobotHeights } from "./robot_model";

type Corner = readonly [x: number, y: number];

const HALF = (CONE_DEG * Math.PI) / 180;
/** Steps of the arc of a sonar's cone, and thickness of the arc where an echo came from. */
const STEPS = 5;
const ECHO_M = 0.035;

/** What sonars and laser scanner measure, as fans at the height of the sensors. */
export class Fans {
  readonly group = new Group();
  private readonly sonar: Fan;
  private readonly echoes: Fan;
  private readonly laser: Fan;

  constructor(
    private readonly robot: Robot,
    { deck, top }: RobotHeights,
    colours: Colours,
  ) {
    this.sonar = new Fan(colours.path, 0.2, 0.75 * deck);
    this.echoes = new Fan(colours.path, 0.95, 0.75 * deck + 0.001);
    this.laser = new Fan(colours.start, 0.22, top + 0.05);
    this.group.add(this.sonar.mesh, this.echoes.mesh, this.laser.mesh);
  }

  show(ranges: Measurements | null): void {
    const { sonars, sonar_range_m } = this.robot;
    const cones = (ranges?.sonar ?? []).flatMap((metres, index) => {
      const sonar = sonars[index];
      return sonar ? [{ sonar, metres, isNear: metres < sonar_range_m - FAR_M }] : [];
    });
    const near = cones.filter(({ isNear }) => isNear);
    // where nothing is near, a cone would hide the floor up to the walls
    this.sonar.show(near.flatMap(({ sonar, metres }) => coneOf(sonar, metres)));
    this.echoes.show(near.flatMap(({ sonar, metres }) => echoOf(sonar, metres)));
    this.laser.show(ranges?.lidar ? this.scanOf(ranges.lidar) : []);
  }

  dispose(): void {
    for (const fan of [this.sonar, this.echoes, this.laser]) fan.dispose();
    this.group.removeFromParent();
  }

  private scanOf(beams: readonly number[]): Corner[] {
    const { laser } = this.robot;
    if (!laser) return [];
    const from: Corner = [laser.x_m, laser.y_m];
    const ends = beams.map((metres, degree): Corner => {
      const angle = ((degree - laser.field_deg / 2) * Math.PI) / 180;
      return [from[0] + metres * Math.cos(angle), from[1] + metres * Math.sin(angle)];
    });
    const round = laser.field_deg < 360 ? ends : [...ends, ...ends.slice(0, 1)];
    return round.slice(1).flatMap((end, index) => [from, round[index] ?? from, end]);
  }
}

interface Ray {
  readonly x_m: number;
  readonly y_m: number;
  readonly angle_rad: number;
}

const arcOf = ({ x_m, y_m, angle_rad }: Ray, metres: number): Corner[] =>
  Array.from({ length: STEPS + 1 }, (_, step) => {
    const angle = angle_rad + HALF * ((2 * step) / STEPS - 1);
    return [x_m + metres * Math.cos(angle), y_m + metres * Math.sin(angle)];
  });

function coneOf(ray: Ray, metres: number): Corner[] {
  const arc = arcOf(ray, metres);
  return arc.slice(1).flatMap((end, index) => [[ray.x_m, ray.y_m], arc[index] ?? end, end]);
}

function echoOf(ray: Ray, metres: number): Corner[] {
  const [outer, inner] = [arcOf(ray, metres), arcOf(ray, Math.max(0, metres - ECHO_M))];
  return outer.slice(1).flatMap((end, index) => {
    const [from = end, back = end, next = end] = [outer[index], inner[index], inner[index + 1]];
    return [from, end, next, from, next, back];
  });
}

/** Flat triangles at one height. */
class Fan {
  readonly mesh: Mesh<BufferGeometry, MeshBasicMaterial>;

  constructor(
    colour: string,
    opacity: number,
    private readonly z: number,
  ) {
    const material = new MeshBasicMaterial({
      color: new Color(colour),
      opacity,
      transparent: true,
      depthWrite: false,
      side: DoubleSide,
    });
    this.mesh = new Mesh(new BufferGeometry(), material);
    this.mesh.renderOrder = 10;
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  show(corners: readonly Corner[]): void {
    this.mesh.visible = corners.length > 0;
    if (!this.mesh.visible) return;
    const positions = new Float32Array(corners.flatMap(([x, y]) => [x, y, this.z]));
    this.mesh.geometry.dispose();
    this.mesh.geometry = new BufferGeometry();
    this.mesh.geometry.setAttribute("position", new BufferAttribute(positions, 3));
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}
