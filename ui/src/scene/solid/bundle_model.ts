import { Group, MeshBasicMaterial } from "three";
import type { Point } from "../../run/trail";
import type { Bundle, BundlePath } from "../bundle/bundle";
import type { Colours } from "../colours";
import { Ribbon } from "./ribbon";

/** Heights over the floor, metres: nearer to it, the depth of a frame could not tell them from it. */
const Z = { well: 0.004, badly: 0.005, rim: 0.006, end: 0.007 };
const LINE_M = 0.024;
const DOT_M = 0.055;
const CROSS_M = 0.07;
const CROSS_LINE_M = 0.035;
const RIM_M = 0.014;
const ROUND = 12;

/** Paths of many robots as thin flat lines, and their ends; world frame. A path that arrives costs only itself. */
export class BundleModel {
  readonly group = new Group();
  private readonly lines = material();
  private readonly marks = material();
  private readonly well = new Ribbon(this.lines, { width: LINE_M, z: Z.well });
  private readonly badly = new Ribbon(this.lines, {
    width: LINE_M,
    z: Z.badly,
    dash: [0.06, 0.04],
  });
  private readonly dotRims = new Ribbon(this.marks, { width: DOT_M + RIM_M, z: Z.rim });
  private readonly crossRims = new Ribbon(this.marks, {
    width: CROSS_LINE_M + 2 * RIM_M,
    z: Z.rim,
  });
  private readonly dots = new Ribbon(this.marks, { width: DOT_M, z: Z.end });
  private readonly crosses = new Ribbon(this.marks, { width: CROSS_LINE_M, z: Z.end });
  private shown: readonly BundlePath[] = [];

  constructor(private readonly colours: Colours) {
    for (const { mesh } of this.ribbons) this.group.add(mesh);
  }

  show(bundle: Bundle | null): void {
    const paths = bundle?.paths ?? [];
    this.lines.opacity = bundle?.isFaint ? 0.12 : 0.5;
    this.marks.opacity = bundle?.isFaint ? 0.25 : 1;
    const isMore = this.shown.every(({ path }, index) => path === paths[index]?.path);
    if (!isMore) for (const ribbon of this.ribbons) ribbon.cut(0);
    for (const one of paths.slice(isMore ? this.shown.length : 0)) this.append(one);
    for (const ribbon of this.ribbons) ribbon.upload();
    this.shown = paths;
  }

  dispose(): void {
    for (const ribbon of this.ribbons) ribbon.dispose();
    this.lines.dispose();
    this.marks.dispose();
    this.group.removeFromParent();
  }

  private get ribbons(): readonly Ribbon[] {
    const { well, badly, dotRims, crossRims, dots, crosses } = this;
    return [well, badly, dotRims, crossRims, dots, crosses];
  }

  private append({ path, well }: BundlePath): void {
    const { tile, path: good, markX } = this.colours;
    (well ? this.well : this.badly).append(path, well ? good : markX);
    const end = path.at(-1);
    if (!end) return;
    if (well) {
      this.dotRims.append(circle(end, (DOT_M + RIM_M) / 2), tile);
      this.dots.append(circle(end, DOT_M / 2), good);
      return;
    }
    for (const line of cross(end)) {
      this.crossRims.append(line, tile);
      this.crosses.append(line, markX);
    }
  }
}

const material = () =>
  new MeshBasicMaterial({ vertexColors: true, depthWrite: false, transparent: true });

/** A line whose own width fills the circle: from the middle to twice the radius. */
const circle = ([x, y]: Point, radius: number): Point[] =>
  Array.from({ length: ROUND + 1 }, (_, index) => {
    const angle = (index * 2 * Math.PI) / ROUND;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  });

const cross = ([x, y]: Point): Point[][] =>
  [-1, 1].map((sign) => [
    [x - CROSS_M, y - sign * CROSS_M],
    [x + CROSS_M, y + sign * CROSS_M],
  ]);
