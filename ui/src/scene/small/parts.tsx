import type { XY } from "../frames";
import { paintOf } from "../paints";
import { type GoalViewport, pointsOf } from "./goal_viewport";

interface GridProps {
  viewport: GoalViewport;
  /** Distance between the lines, metres. */
  every?: number;
}

/** The visible lines of the metre grid. */
export function Grid({ viewport: { box, toPixels }, every = 1 }: GridProps) {
  const [from, to] = [
    toPixels({ x: box.left, y: box.top }),
    toPixels({ x: box.right, y: box.bottom }),
  ];
  const across = stepsIn(box.left, box.right, every).map(
    (x) => `M${toPixels({ x, y: 0 }).x} ${from.y}V${to.y}`,
  );
  const up = stepsIn(box.bottom, box.top, every).map(
    (y) => `M${from.x} ${toPixels({ x: 0, y }).y}H${to.x}`,
  );
  return <path class="goal__grid" d={[...across, ...up].join("")} />;
}

function stepsIn(from: number, to: number, every: number): number[] {
  const first = Math.ceil(from / every);
  const n = Math.max(0, Math.floor(to / every) - first + 1);
  return Array.from({ length: n }, (_, index) => (first + index) * every);
}

interface LineProps {
  viewport: GoalViewport;
  points: readonly (readonly number[])[];
  /** Colour of the pen; null for a line that the robot drives without a pen. */
  color?: string | null;
  /** Whether an edge separates the line from the drawing below it. */
  edged?: boolean;
}

/** A line that the robot drove or drew, or is to drive or draw. */
export function Line({ viewport, points, color = null, edged = true }: LineProps) {
  const line = pointsOf(points)
    .map(viewport.toPixels)
    .map(({ x, y }) => `${x},${y}`)
    .join(" ");
  return (
    <g style={color === null ? {} : { "--goal-line": paintOf(color) }}>
      {edged && <polyline class="goal__edge" points={line} />}
      <polyline class="goal__line" points={line} />
    </g>
  );
}

/** The start of a path. */
export function StartMark({ at: { x, y } }: { at: XY }) {
  return <circle class="path-picture__start" cx={x} cy={y} r="5" />;
}
