import type { BelievedPose } from "../api/model";
import { texts } from "../i18n";
import type { XY } from "../scene/frames";
import { extentOf, hullPath } from "../scene/hull";
import { type GoalViewport, HEIGHT, viewportOfPath, WIDTH } from "../scene/small/goal_viewport";
import { Grid, StartMark } from "../scene/small/parts";
import { robotOf } from "../shell/session";

/** If a metre has fewer pixels than this, the grid has a line every 5 m. */
const DENSE = 12;

/** Least length of a robot in pixels, so that its heading is readable in a large room. */
const MIN_ROBOT_PX = 22;

interface TruthPictureProps {
  believed: BelievedPose | null;
  measured: BelievedPose | null;
  /** Name of the robot's model. */
  model: string | null;
}

/** The floor from above as a person at the start mark sees it: ahead is up, left is left. */
export function TruthPicture({ believed, measured, model }: TruthPictureProps) {
  const poses = [believed, measured].filter((pose) => pose !== null);
  const viewport = viewportOfPath(poses.map(seen));
  const start = viewport.toPixels({ x: 0, y: 0 });
  return (
    <svg
      class="path-picture truth-picture"
      viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
      role="img"
      aria-label={texts.value.truth.picture}
    >
      <Grid viewport={viewport} every={viewport.scale < DENSE ? 5 : 1} />
      {measured && <TapeLine viewport={viewport} to={measured} />}
      <StartMark at={start} />
      <path class="truth-picture__ahead" d={`M${start.x} ${start.y - 7}v-9m-4 4 4-4 4 4`} />
      {believed && <RobotMark kind="believed" at={believed} viewport={viewport} model={model} />}
      {measured && <RobotMark kind="measured" at={measured} viewport={viewport} model={model} />}
    </svg>
  );
}

/** A place of the start frame as the picture has it. */
const seen = ({ x_m, y_m }: BelievedPose): XY => ({ x: -y_m, y: x_m });

/** How the tape lies: ahead along the start's heading, then to the side. */
function TapeLine({ viewport, to }: { viewport: GoalViewport; to: BelievedPose }) {
  const start = viewport.toPixels({ x: 0, y: 0 });
  const end = viewport.toPixels(seen(to));
  return <path class="truth-picture__tape" d={`M${start.x} ${start.y}V${end.y}H${end.x}`} />;
}

interface RobotMarkProps {
  kind: "believed" | "measured";
  at: BelievedPose;
  viewport: GoalViewport;
  model: string | null;
}

function RobotMark({ kind, at, viewport, model }: RobotMarkProps) {
  const robot = robotOf(model);
  if (!robot) return null;
  const { x, y } = viewport.toPixels(seen(at));
  const { length, width, back } = extentOf(robot);
  const scale = Math.max(viewport.scale, MIN_ROBOT_PX / length);
  const turn = -90 - (at.heading_rad * 180) / Math.PI;
  return (
    <g
      class={`truth-picture__robot truth-picture__robot--${kind}`}
      transform={`translate(${x} ${y}) rotate(${turn}) scale(${scale})`}
    >
      <path style={{ strokeWidth: 2 / scale }} d={hullPath(robot)} />
      <path
        class="truth-picture__nose"
        transform={`translate(${back} 0) scale(${length} ${width})`}
        d="M.69 0 .35.26.42 0 .35-.26z"
      />
    </g>
  );
}
