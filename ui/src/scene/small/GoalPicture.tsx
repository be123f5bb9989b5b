import type { GoalPicture as Goal, GoalLine } from "../../api/model";
import { robotOf } from "../../shell/session";
import type { XY } from "../frames";
import { extentOf } from "../hull";
import { GroundPicture, NamesPicture, ObjectsPicture } from "./GroundPicture";
import {
  type GoalViewport,
  HEIGHT,
  middleOf,
  pointsOf,
  viewportOfGoal,
  WIDTH,
} from "./goal_viewport";
import { ROBOT_ICON, WaitingRobot } from "./PathPicture";
import { Line } from "./parts";

interface GoalPictureProps {
  goal: Goal;
  /** Text for screen readers; absent if a text beside the picture describes the same. */
  label?: string;
}

/** Picture of an activity's goal: the floor, the robot at the start, the targets, the lines to drive or draw. */
export function GoalPicture({ goal, label }: GoalPictureProps) {
  const viewport = viewportOfGoal(goal);
  return (
    <svg
      class="goal"
      viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
      role="img"
      aria-label={label}
      aria-hidden={label ? undefined : "true"}
    >
      <GroundPicture goal={goal} viewport={viewport} />
      {goal.lines.map((line, index) => (
        <Line key={index} viewport={viewport} points={line.points} color={line.color} />
      ))}
      <ObjectsPicture goal={goal} viewport={viewport} />
      <StartedRobot goal={goal} viewport={viewport} />
      <NamesPicture goal={goal} viewport={viewport} />
      {goal.lines.map((line, index) => (
        <Marks key={index} line={line} viewport={viewport} />
      ))}
    </svg>
  );
}

interface PartProps {
  goal: Goal;
  viewport: GoalViewport;
}

/** Minimum scale of a robot's icon: a smaller icon is not recognisable. */
const MIN_ROBOT_SCALE = 0.55;

function StartedRobot({ goal: { world }, viewport }: PartProps) {
  const { x_m, y_m, heading_deg } = world.start;
  const robot = robotOf(null);
  const length = robot ? extentOf(robot).length : 0;
  const size = Math.max(MIN_ROBOT_SCALE, (length * viewport.scale) / ROBOT_ICON);
  const { x, y } = viewport.toPixels({ x: x_m, y: y_m });
  return (
    <g transform={`translate(${x} ${y}) rotate(${-heading_deg}) scale(${size})`}>
      <WaitingRobot at={[0, 0]} />
    </g>
  );
}

interface LineProps {
  line: GoalLine;
  viewport: GoalViewport;
}

/** Arrows and sign of a line, above everything else. */
function Marks({ line: { points, color, sign }, viewport }: LineProps) {
  const places = pointsOf(points).map(viewport.toPixels);
  return (
    <>
      {color === null && <Arrows places={places} />}
      {sign !== null && <Sign sign={sign} at={middleOf(places)} />}
    </>
  );
}

/** Minimum length of a stretch with an arrow head; an end closer to the start gets none either. */
const MIN_STRETCH_PX = 22;

/** The driving direction: an arrow head on the first stretch, and one at the end unless it is the start. */
function Arrows({ places }: { places: readonly XY[] }) {
  const [first, second] = places;
  const [last, before] = [places.at(-1), places.at(-2)];
  if (!first || !second || !last || !before) return null;
  const middle = { x: (first.x + second.x) / 2, y: (first.y + second.y) / 2 };
  return (
    <>
      {places.length > 2 && distance(first, second) > MIN_STRETCH_PX && (
        <ArrowHead at={middle} from={first} />
      )}
      {distance(first, last) > MIN_STRETCH_PX && <ArrowHead at={last} from={before} />}
    </>
  );
}

function ArrowHead({ at: { x, y }, from }: { at: XY; from: XY }) {
  const turn = (Math.atan2(y - from.y, x - from.x) * 180) / Math.PI;
  return (
    <path class="goal__arrow" d="M8 0-7-8v16z" transform={`translate(${x} ${y}) rotate(${turn})`} />
  );
}

const distance = (one: XY, other: XY) => Math.hypot(one.x - other.x, one.y - other.y);

/** The sign that the line answers, in the middle of the drawn figure. */
function Sign({ sign, at: { x, y } }: { sign: string; at: XY }) {
  const width = 16 + 10 * sign.length;
  return (
    <g transform={`translate(${x} ${y})`}>
      <rect class="goal__sign" x={-width / 2} y="-13" width={width} height="26" rx="13" />
      <text class="goal__letter" y="1">
        {sign}
      </text>
    </g>
  );
}
