import { texts } from "../../i18n";
import { numberIn } from "../../kit/NumberField";
import { poseInRoom, robotStates } from "../../run/real/robot_state";
import { extentOf, hullPath } from "../../scene/hull";
import { robotOf } from "../../shell/session";
import type { Draft } from "./robot_description";

interface RoomPictureProps {
  draft: Draft;
  /** Link of the robot whose pose is drawn while it is watched. */
  link?: string;
}

/** The free floor with the start of the form, and the robot; renders nothing while a number is missing. */
export function RoomPicture({ draft, link }: RoomPictureProps) {
  const number = (name: string) => numberIn(draft[`room.${name}`] ?? "");
  const [width, depth, x, y] = ["width_m", "depth_m", "x_m", "y_m"].map(number);
  const heading = number("heading_deg");
  if (!width || !depth || x == null || y == null || heading === null) return null;
  const edge = Math.max(width, depth) / 50;
  const box = [-width / 2 - edge, -depth / 2 - edge, width + 2 * edge, depth + 2 * edge];
  return (
    <svg
      class="room-picture"
      viewBox={box.join(" ")}
      role="img"
      aria-label={texts.value.robotSetup.picture}
    >
      <rect
        class="room-picture__floor"
        x={-width / 2}
        y={-depth / 2}
        width={width}
        height={depth}
      />
      <g transform={`translate(${x} ${-y}) rotate(${-heading})`}>
        <Hull hull="room-picture__robot" nose="room-picture__nose" />
      </g>
      {link && <RobotPose link={link} />}
    </svg>
  );
}

/** Pose of the watched robot, by its odometry. */
function RobotPose({ link }: { link: string }) {
  const state = robotStates.value[link];
  const place = state && poseInRoom(state);
  if (!place) return null;
  return (
    <g
      data-testid="robot-place"
      transform={`translate(${place.x_m} ${-place.y_m}) rotate(${-place.heading_deg})`}
    >
      <Hull hull="room-picture__place" nose="room-picture__place" />
    </g>
  );
}

/** Outline of the robot, and a line to its front. */
function Hull({ hull, nose }: { hull: string; nose: string }) {
  const robot = robotOf(null);
  if (!robot) return null;
  return (
    <>
      <path class={hull} d={hullPath(robot)} />
      <path class={nose} d={`M 0 0 H ${extentOf(robot).front}`} />
    </>
  );
}
