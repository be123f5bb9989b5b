import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DynamicDrawUsage,
  Mesh,
  type MeshBasicMaterial,
} from "three";
import type { Point, Trail } from "../../run/trail";
import { begins } from "../scene_cache";

/** Numbers of a corner: position, or colour. */
const N = 3;
/** Corners of one segment: two triangles of its own, four where it meets the one before. */
const CORNERS = 18;
/** Cosine of the angle above which a bend has a tip. */
const SHARPEST = -0.5;

interface RibbonShape {
  /** Width in metres, and height over the floor: ribbons lie in layers. */
  readonly width: number;
  readonly z: number;
  /** Lengths of a dash and of the gap after it, metres; absent for a continuous line. */
  readonly dash?: readonly [number, number];
}

/**
 * A flat line on the floor that grows at its end. What was appended as fixed is never computed again, so a frame of a
 * long run costs no more than one of a short run.
 */
export class Ribbon {
  readonly mesh: Mesh<BufferGeometry, MeshBasicMaterial>;
  private positions = new Float32Array(0);
  private colours = new Float32Array(0);
  /** Number of corners: in use, and fixed. */
  private used = 0;
  private fixed = 0;
  private changedFrom = 0;
  private length = 0;
  private readonly colour = new Color();

  constructor(
    material: MeshBasicMaterial,
    private readonly shape: RibbonShape,
  ) {
    this.mesh = new Mesh(new BufferGeometry(), material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = shape.z * 1000;
    this.grow(256 * CORNERS);
  }

  get size(): number {
    return this.used;
  }

  /** Removes everything behind a size; the rest is fixed. */
  cut(size: number): void {
    this.used = size;
    this.fixed = size;
    this.changedFrom = Math.min(this.changedFrom, size);
    if (size === 0) this.length = 0;
  }

  /** Appends a line that stays. */
  append(points: readonly Point[], colour: string): void {
    this.used = this.fixed;
    this.write(points, colour);
    this.fixed = this.used;
  }

  /** Replaces all that was not appended as fixed. */
  end(points: readonly Point[], colour: string): void {
    const { length } = this;
    this.used = this.fixed;
    this.write(points, colour);
    this.length = length;
  }

  /** Passes what changed to the graphics card. */
  upload(): void {
    const { geometry } = this.mesh;
    const count = this.used - this.changedFrom;
    for (const name of count > 0 ? ["position", "color"] : []) {
      const attribute = geometry.getAttribute(name) as BufferAttribute;
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(this.changedFrom * N, count * N);
      attribute.needsUpdate = true;
    }
    geometry.setDrawRange(0, this.used);
    this.mesh.visible = this.used > 0;
    this.changedFrom = this.fixed;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
  }

  private write(points: readonly Point[], colour: string): void {
    this.changedFrom = Math.min(this.changedFrom, this.used);
    this.colour.set(colour);
    let before: Point | null = null;
    for (let at = 1; at < points.length; at++) {
      const [from, to] = [points[at - 1], points[at]];
      if (!from || !to) continue;
      const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
      if (length === 0) continue;
      this.segment(before, from, to, length);
      before = from;
    }
  }

  /** Writes the dashes of a segment; `before` is the point before it, to close the gap at a bend. */
  private segment(before: Point | null, from: Point, to: Point, length: number): void {
    const { dash } = this.shape;
    const along = (part: number): Point => [
      from[0] + (to[0] - from[0]) * part,
      from[1] + (to[1] - from[1]) * part,
    ];
    if (!dash) this.quad(before, from, to);
    else {
      const [on, off] = dash;
      for (let done = 0; done < length - 1e-9; ) {
        const phase = (this.length + done) % (on + off);
        const isOn = phase < on;
        const step = Math.min(length - done, Math.max(1e-6, (isOn ? on : on + off) - phase));
        if (isOn)
          this.quad(
            done === 0 ? before : null,
            along(done / length),
            along((done + step) / length),
          );
        done += step;
      }
    }
    this.length += length;
  }

  private quad(before: Point | null, from: Point, to: Point): void {
    const [ax, ay] = this.aside(from, to);
    const [bx, by] = before ? this.aside(before, from) : [ax, ay];
    const [left, right] = [at(from, ax, ay), at(from, -ax, -ay)];
    const [leftEnd, rightEnd] = [at(to, ax, ay), at(to, -ax, -ay)];
    const corners = [left, right, rightEnd, left, rightEnd, leftEnd];
    this.push([...corners, ...bendOf(from, [ax, ay], [bx, by])]);
  }

  /** From the middle of the line to its left side. */
  private aside(from: Point, to: Point): Point {
    const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    const half = this.shape.width / 2 / (Math.hypot(dx, dy) || 1);
    return [-dy * half, dx * half];
  }

  private push(corners: readonly Point[]): void {
    if ((this.used + corners.length) * N > this.positions.length)
      this.grow(2 * (this.used + corners.length));
    const { r, g, b } = this.colour;
    for (const [x, y] of corners) {
      this.positions.set([x, y, this.shape.z], this.used * N);
      this.colours.set([r, g, b], this.used * N);
      this.used++;
    }
  }

  private grow(corners: number): void {
    this.mesh.geometry.dispose();
    const geometry = new BufferGeometry();
    [this.positions, this.colours] = [this.positions, this.colours].map((old) => {
      const values = new Float32Array(corners * N);
      values.set(old);
      return values;
    }) as [Float32Array<ArrayBuffer>, Float32Array<ArrayBuffer>];
    for (const [name, values] of [
      ["position", this.positions],
      ["color", this.colours],
    ] as const) {
      geometry.setAttribute(name, new BufferAttribute(values, N).setUsage(DynamicDrawUsage));
    }
    this.mesh.geometry = geometry;
    this.changedFrom = 0;
  }
}

/** Fills the corner between two segments that meet, up to the point where their edges cross. */
function bendOf(from: Point, [ax, ay]: Point, [bx, by]: Point): Point[] {
  const cos = (ax * bx + ay * by) / (ax * ax + ay * ay);
  const reach = cos > SHARPEST ? 1 / (1 + cos) : 0.5;
  return [1, -1].flatMap((side) => {
    const [a, b] = [at(from, side * ax, side * ay), at(from, side * bx, side * by)];
    const tip = at(from, side * reach * (ax + bx), side * reach * (ay + by));
    return side > 0 ? [from, b, tip, from, tip, a] : [from, tip, b, from, a, tip];
  });
}

const at = ([x, y]: Point, dx: number, dy: number): Point => [x + dx, y + dy];

/** The ribbon of one trail of a run. */
export class TrailRibbon {
  private trail: Trail | null = null;
  private drawn = 0;

  constructor(
    readonly ribbon: Ribbon,
    private readonly colour: string,
  ) {}

  /** Shows a state of the trail; it ends at the robot (`end`), if there is one. */
  show(trail: Trail, end: Point | null): void {
    if (this.trail && !begins(this.trail, trail, this.drawn)) this.restart();
    const { chunks, tail } = trail;
    for (; this.drawn < chunks.length; this.drawn++) {
      this.ribbon.append(
        [...jointOf(chunks, this.drawn), ...(chunks[this.drawn] ?? [])],
        this.colour,
      );
    }
    this.trail = trail;
    this.ribbon.end([...jointOf(chunks, this.drawn), ...tail, ...(end ? [end] : [])], this.colour);
    this.ribbon.upload();
  }

  private restart(): void {
    this.ribbon.cut(0);
    this.drawn = 0;
  }
}

/** Points drawn twice where two parts of a line meet, so that the bend between them is filled. */
const JOINT = 2;

/** The last points before a chunk. */
export function jointOf(chunks: Trail["chunks"], index: number): readonly Point[] {
  return chunks[index - 1]?.slice(-JOINT) ?? [];
}
