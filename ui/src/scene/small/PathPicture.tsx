import { frameOfPath, HEIGHT, pointsOf, WIDTH } from "./frame";
import { Grid, Line, StartMark } from "./parts";

type Points = readonly (readonly number[])[];

/** Where metres are smaller than this many pixels, the grid has lines every 5 m. */
const DENSE = 12;

/** Small picture of a run's path, with a grid that shows its size. */
export function PathPicture({ path }: { path: Points }) {
  const frame = frameOfPath(pointsOf(path));
  const start = frame.place({ x: 0, y: 0 });
  const last = pointsOf(path.slice(-1)).map(frame.place)[0];
  return (
    <svg
      class="path-picture"
      viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
      preserveAspectRatio="xMidYMid slice"
      aria-hidden="true"
    >
      <Grid frame={frame} every={frame.scale < DENSE ? 5 : 1} />
      {last && path.length > 1 ? (
        <>
          <Line frame={frame} points={path} edged={false} />
          <StartMark at={start} />
          <circle class="path-picture__robot" cx={last.x} cy={last.y} r="8" />
        </>
      ) : (
        <WaitingRobot at={[start.x, start.y]} />
      )}
    </svg>
  );
}

/** Nothing has been driven yet: the robot stands at the start pose. */
export function WaitingRobot({ at: [x, y] }: { at: readonly [number, number] }) {
  return (
    <g class="path-picture__waiting" transform={`translate(${x} ${y})`}>
      <rect x="-5" y="-14" width="14" height="5" rx="2" />
      <rect x="-5" y="9" width="14" height="5" rx="2" />
      <path class="path-picture__robot" d="M-16-7q0-4 5-4H6q11 1.500 11 11T6 11h-17q-5 0-5-4z" />
      <path fill="#fff" d="M9 0-4 6l3-6-3-6z" />
    </g>
  );
}
