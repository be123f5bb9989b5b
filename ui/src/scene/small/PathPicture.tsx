import { robotOf } from "../../shell/session";
import { extentOf, hullPath } from "../hull";
import { HEIGHT, pointsOf, viewportOfPath, WIDTH } from "./goal_viewport";
import { Grid, Line, StartMark } from "./parts";

type Points = readonly (readonly number[])[];

/** If a metre has fewer pixels than this, the grid has a line every 5 m. */
const DENSE = 12;

interface PathPictureProps {
  path: Points;
  /** Whether the run stopped before its end: a warning sign is where the robot then was. */
  failed?: boolean;
}

/** Small picture of a run's path, with a grid that shows its size. */
export function PathPicture({ path, failed = false }: PathPictureProps) {
  const viewport = viewportOfPath(pointsOf(path));
  const start = viewport.toPixels({ x: 0, y: 0 });
  const last = pointsOf(path.slice(-1)).map(viewport.toPixels)[0];
  return (
    <svg
      class="path-picture"
      viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
      preserveAspectRatio="xMidYMid slice"
      aria-hidden="true"
    >
      <Grid viewport={viewport} every={viewport.scale < DENSE ? 5 : 1} />
      {last && path.length > 1 ? (
        <>
          <Line viewport={viewport} points={path} edged={false} />
          <StartMark at={start} />
          {failed ? (
            <FailedMark at={[last.x, last.y]} />
          ) : (
            <circle class="path-picture__robot" cx={last.x} cy={last.y} r="8" />
          )}
        </>
      ) : (
        <WaitingRobot at={[start.x, start.y]} />
      )}
    </svg>
  );
}

/** The sign of a failed run, as beside its outcome. */
function FailedMark({ at: [x, y] }: { at: readonly [number, number] }) {
  return (
    <g class="path-picture__failed" transform={`translate(${x} ${y})`}>
      <path d="M0 -14 14 0 0 14 -14 0z" />
      <path class="path-picture__exclamation" d="M0 -6.5V1M0 6v.4" />
    </g>
  );
}

/** Length of the icon of a robot, which is not drawn to the scale of its picture. */
export const ROBOT_ICON = 32;

/** The icon of the default robot at the start pose, before any run. */
export function WaitingRobot({ at: [x, y] }: { at: readonly [number, number] }) {
  const robot = robotOf(null);
  if (!robot) return null;
  const { back, length, width } = extentOf(robot);
  return (
    <g
      class="path-picture__waiting"
      transform={`translate(${x} ${y}) scale(${ROBOT_ICON / length})`}
    >
      {robot.wheels.map(({ x_m, y_m, radius_m, width_m }) => (
        <rect
          key={y_m}
          x={x_m - radius_m}
          y={-y_m - width_m / 2}
          width={2 * radius_m}
          height={width_m}
          rx={0.36 * width_m}
        />
      ))}
      <path
        class="path-picture__robot"
        style={{ strokeWidth: (2 * length) / ROBOT_ICON }}
        d={hullPath(robot)}
      />
      <path
        fill="#fff"
        transform={`translate(${back} 0) scale(${length} ${width})`}
        d="M.69 0 .35.26.42 0 .35-.26z"
      />
    </g>
  );
}
