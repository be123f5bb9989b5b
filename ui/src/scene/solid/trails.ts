import { Group, MeshBasicMaterial } from "three";
import type { FloorMark, Output, Stroke } from "../../run/output";
import type { RunView } from "../../run/reducer";
import type { Point } from "../../run/trail";
import type { Colours } from "../colours";
import type { Companion } from "../companion";
import { MARK_LINE_M, MARK_M, PEN_M } from "../drawings";
import { edgeOf, paintOf } from "../paints";
import { begins, hasSameStroke } from "../scene_cache";
import { jointOf, Ribbon, TrailRibbon } from "./ribbon";

/** Heights of the layers over the floor, metres, in the order of the drawing from above. */
const Z = {
  ideal: 0.002,
  path: 0.003,
  measured: 0.0035,
  edge: 0.004,
  pen: 0.005,
  markEdge: 0.006,
  mark: 0.007,
};
const PATH_M = 0.08;
const IDEAL_M = 0.025;
const MEASURED_M = 0.05;
const EDGE_M = 0.012;

/** Everything that a run leaves on the floor: its path, the ideal path, strokes of the pen and marks. */
export class Trails {
  readonly group = new Group();
  private readonly material = new MeshBasicMaterial({ vertexColors: true, depthWrite: false });
  private readonly ideal: TrailRibbon;
  private readonly path: TrailRibbon;
  private readonly measured: Ribbon;
  private shownMeasured: Companion["measured"];
  private readonly strokes: Strokes;
  private readonly marks: readonly [Ribbon, Ribbon];
  private shownMarks: readonly FloorMark[] = [];

  constructor(
    private readonly colours: Colours,
    { isDashed }: { isDashed: boolean },
  ) {
    const ribbon = (width: number, z: number, dash?: readonly [number, number]) =>
      new Ribbon(this.material, { width, z, ...(dash && { dash }) });
    this.ideal = new TrailRibbon(ribbon(IDEAL_M, Z.ideal, [0.05, 0.06]), colours.ideal);
    this.path = isDashed
      ? new TrailRibbon(ribbon(PATH_M, Z.path, [0.12, 0.07]), colours.start)
      : new TrailRibbon(ribbon(PATH_M, Z.path), colours.path);
    this.measured = ribbon(MEASURED_M, Z.measured, [MEASURED_M, MEASURED_M]);
    this.strokes = new Strokes(ribbon(PEN_M + 2 * EDGE_M, Z.edge), ribbon(PEN_M, Z.pen), colours);
    this.marks = [ribbon(MARK_LINE_M + 0.04, Z.markEdge), ribbon(MARK_LINE_M, Z.mark)];
    for (const { mesh } of this.ribbons) this.group.add(mesh);
  }

  /** Shows a state of a run; lines end at the robot (`end`), if it is there. */
  show({ path, idealPath, output }: RunView, end: Point | null): void {
    this.ideal.show(idealPath, null);
    this.path.show(path, end);
    this.strokes.show(output, end);
    if (output.marks === this.shownMarks) return;
    this.shownMarks = output.marks;
    this.drawMarks();
  }

  /** Shows the pieces of a path that a source of truth saw, dotted. */
  showMeasured(pieces: Companion["measured"]): void {
    if (pieces === this.shownMeasured) return;
    this.shownMeasured = pieces;
    this.measured.cut(0);
    for (const piece of pieces ?? []) this.measured.append(piece, this.colours.measured);
    this.measured.upload();
  }

  dispose(): void {
    for (const ribbon of this.ribbons) ribbon.dispose();
    this.material.dispose();
    this.group.removeFromParent();
  }

  private get ribbons(): readonly Ribbon[] {
    const { ideal, path, measured, strokes, marks } = this;
    return [ideal.ribbon, path.ribbon, measured, ...strokes.ribbons, ...marks];
  }

  private drawMarks(): void {
    const { tile, markX, markO } = this.colours;
    const [edges, lines] = this.marks;
    for (const ribbon of this.marks) ribbon.cut(0);
    for (const mark of this.shownMarks) {
      const isCross = mark.symbol === "X";
      for (const line of isCross ? crossOf(mark) : [circleOf(mark)]) {
        edges.append(line, tile);
        lines.append(line, isCross ? markX : markO);
      }
    }
    for (const ribbon of this.marks) ribbon.upload();
  }
}

const ROUND = 36;

const circleOf = ({ x, y }: FloorMark): Point[] =>
  Array.from({ length: ROUND + 1 }, (_, index) => {
    const angle = (index * 2 * Math.PI) / ROUND;
    return [x + MARK_M * Math.cos(angle), y + MARK_M * Math.sin(angle)];
  });

function crossOf({ x, y }: FloorMark): Point[][] {
  const reach = 0.9 * MARK_M;
  return [-1, 1].map((sign) => [
    [x - reach, y - reach * sign],
    [x + reach, y + reach * sign],
  ]);
}

/** The strokes of the pen, each with an edge where its colour is close to that of the floor. */
class Strokes {
  readonly ribbons: readonly [Ribbon, Ribbon];
  private shown: Output | null = null;
  /** Number of finished strokes, and of full chunks of the unfinished one, that are drawn. */
  private finished = 0;
  private chunks = 0;
  /** Sizes of the ribbons before the unfinished stroke. */
  private begin: readonly number[] = [0, 0];

  constructor(
    edges: Ribbon,
    fills: Ribbon,
    private readonly colours: Colours,
  ) {
    this.ribbons = [edges, fills];
  }

  show(output: Output, end: Point | null): void {
    if (!this.continues(output)) this.cutTo([0, 0], 0);
    const { strokes, pen } = output;
    if (strokes.length > this.finished) {
      this.cutTo(this.begin, this.finished);
      for (const stroke of strokes.slice(this.finished)) this.append(stroke);
      this.cutTo(
        this.ribbons.map(({ size }) => size),
        strokes.length,
      );
    }
    if (pen) this.extend(pen, end);
    else for (const ribbon of this.ribbons) ribbon.end([], "");
    for (const ribbon of this.ribbons) ribbon.upload();
    this.shown = output;
  }

  /** Whether what is drawn is also in this state: somebody may have moved the replay back. */
  private continues(output: Output): boolean {
    const { shown } = this;
    if (!shown) return true;
    if (output.strokes.length < this.finished) return false;
    if (!hasSameStroke(shown, output, this.finished - 1)) return false;
    if (this.chunks === 0) return true;
    const now = output.strokes[this.finished] ?? output.pen;
    return Boolean(shown.pen && now && begins(shown.pen.trail, now.trail, this.chunks));
  }

  private cutTo(sizes: readonly number[], finished: number): void {
    this.ribbons.forEach((ribbon, index) => {
      ribbon.cut(sizes[index] ?? 0);
    });
    this.begin = sizes;
    this.finished = finished;
    this.chunks = 0;
  }

  private append({ color, trail }: Stroke): void {
    const points = dotted([...trail.chunks.flat(), ...trail.tail]);
    this.write((ribbon, colour) => ribbon.append(points, colour), color);
  }

  private extend({ color, trail: { chunks, tail } }: Stroke, end: Point | null): void {
    for (; this.chunks < chunks.length; this.chunks++) {
      const points = [...jointOf(chunks, this.chunks), ...(chunks[this.chunks] ?? [])];
      this.write((ribbon, colour) => ribbon.append(points, colour), color);
    }
    const points = dotted([...jointOf(chunks, this.chunks), ...tail, ...(end ? [end] : [])]);
    this.write((ribbon, colour) => ribbon.end(points, colour), color);
  }

  private write(write: (ribbon: Ribbon, colour: string) => void, color: string): void {
    const paint = paintOf(color);
    const [edges, fills] = this.ribbons;
    write(edges, edgeOf(paint, this.colours.tile, this.colours.number) ?? paint);
    write(fills, paint);
  }
}

/** A single point becomes a dot. */
function dotted(points: Point[]): Point[] {
  const [first] = points;
  if (!first || points.length > 1) return points;
  const half = PEN_M / 2;
  return [
    [first[0] - half, first[1]],
    [first[0] + half, first[1]],
  ];
}
