import { robotOf } from "../shell/session";
import { extentOf, hullPath } from "./hull";

type Points = readonly (readonly number[])[];

const WIDTH = 240;
const HEIGHT = 150;
const MARGIN = 24;
/** Scale limit in pixels per metre: a short path is not enlarged further, so that pictures can be compared. */
const LARGEST_SCALE = 56;

interface Frame {
  scale: number;
  x: number;
  y: number;
}

/** Small picture of a run's path, with a metre grid that shows its size. */
export function PathPicture({ path }: { path: Points }) {
  const frame = frameOf(path);
  const place = ([x = 0, y = 0]: readonly number[]) =>
    [frame.x + x * frame.scale, frame.y - y * frame.scale] as const;
  const [startX, startY] = place([0, 0]);
  const last = path.at(-1);
  return (
    <svg
      class="path-picture"
      viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
      preserveAspectRatio="xMidYMid slice"
      aria-hidden="true"
    >
      <path class="path-picture__grid" d={grid(frame)} />
      {path.length > 1 && (
        <polyline
          class="path-picture__path"
          points={path.map((at) => place(at).join()).join(" ")}
        />
      )}
      {last && path.length > 1 ? (
        <>
          <circle class="path-picture__start" cx={startX} cy={startY} r="5" />
          <Robot at={place(last)} />
        </>
      ) : (
        <WaitingRobot at={[startX, startY]} />
      )}
    </svg>
  );
}

function Robot({ at: [x, y] }: { at: readonly [number, number] }) {
  return <circle class="path-picture__robot" cx={x} cy={y} r="8" />;
}

/** Length of the icon of a robot, which is not drawn to the scale of its picture. */
export const ROBOT_ICON = 32;

/** Nothing has been driven yet: the robot, as its record says, stands at the start pose. */
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

function frameOf(path: Points): Frame {
  const xs = [0, ...path.map(([x = 0]) => x)];
  const ys = [0, ...path.map(([, y = 0]) => y)];
  const [left, right] = [Math.min(...xs), Math.max(...xs)];
  const [bottom, top] = [Math.min(...ys), Math.max(...ys)];
  const scale = Math.min(
    LARGEST_SCALE,
    (WIDTH - 2 * MARGIN) / Math.max(0.1, right - left),
    (HEIGHT - 2 * MARGIN) / Math.max(0.1, top - bottom),
  );
  return {
    scale,
    x: WIDTH / 2 - ((left + right) / 2) * scale,
    y: HEIGHT / 2 + ((bottom + top) / 2) * scale,
  };
}

function grid({ scale, x, y }: Frame): string {
  const metres = scale < 12 ? 5 : 1;
  const step = scale * metres;
  const lines: string[] = [];
  for (let at = ((x % step) + step) % step; at < WIDTH; at += step) {
    lines.push(`M${at.toFixed(1)} 0V${HEIGHT}`);
  }
  for (let at = ((y % step) + step) % step; at < HEIGHT; at += step) {
    lines.push(`M0 ${at.toFixed(1)}H${WIDTH}`);
  }
  return lines.join("");
}
