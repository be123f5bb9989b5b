import type { RealRobot, RealRun } from "../../../api/model";

/** The parts of the offered pattern: UMBmark's squares to both sides, and a line, which tells how far a metre is. */
export type Shape = NonNullable<RealRun["shape"]>;
export const SHAPES = ["line", "left", "right"] as const satisfies readonly Shape[];

/** How many measured runs of a part tell enough. */
export const NEEDED: Record<Shape, number> = { line: 1, left: 3, right: 3 };

const [MIN_SIDE_DM, MAX_SIDE_DM] = [5, 20];
/** From the centre of the robot to the edge of the room. */
const MARGIN_M = 0.4;

/** The longest side, in m, of squares to both sides of the robot in each of the rooms; null if none fits. */
export function sideFor(robots: readonly RealRobot[]): number | null {
  for (let dm = MAX_SIDE_DM; dm >= MIN_SIDE_DM; dm--)
    if (robots.every((robot) => fits(robot, dm / 10))) return dm / 10;
  return null;
}

function fits({ world }: RealRobot, side: number): boolean {
  if (!world) return true;
  const [width, depth] = world.size_m;
  const { x_m, y_m, heading_deg } = world.start;
  const heading = (heading_deg * Math.PI) / 180;
  const [cos, sin] = [Math.cos(heading), Math.sin(heading)];
  return [0, side].every((ahead) =>
    [-side, side].every((left) => {
      const [x, y] = [x_m + cos * ahead - sin * left, y_m + sin * ahead + cos * left];
      return Math.abs(x) <= width / 2 - MARGIN_M && Math.abs(y) <= depth / 2 - MARGIN_M;
    }),
  );
}

/** The program of a part. */
export function documentOf(shape: Shape, side: number): object {
  const ahead = { action: "move_forward", distance: side };
  if (shape === "line") return { pinel_ir: 1, commands: [ahead] };
  const turn = { action: "turn", angle: shape === "left" ? 90 : -90 };
  return { pinel_ir: 1, commands: [{ action: "repeat", times: 4, commands: [ahead, turn] }] };
}

export interface Driven {
  readonly measured: number;
  readonly unmeasured: number;
}

/** How many runs there are of a part, on the robot of the newest run. */
export function driven(runs: readonly RealRun[], shape: Shape): Driven {
  const own = runs.filter((run) => run.link === runs[0]?.link && run.shape === shape);
  const measured = own.filter(({ sources }) => sources.length > 0).length;
  return { measured, unmeasured: own.length - measured };
}
