import type { Ring, Robot, World } from "../../api/model";
import type { BoxPoses, Pose } from "../../run/reducer";
import { aheadOf } from "../ahead";
import { startOf, toWorld } from "../frames";
import type { Measurements } from "../ranges_view";

/**
 * Where the beams of sonars and laser scanner end while no run is live: the link of a live run
 * measures, and without a run nothing does.
 *
 * @param pose - of the robot, in the start frame.
 */
export function idleRanges(
  robot: Robot,
  world: World,
  boxes: BoxPoses,
  pose: Pose,
  rings: readonly Ring[],
): Measurements | null {
  const { sonars, sonar_range_m, laser } = robot;
  const reach = (x_m: number, y_m: number, angle: number, range_m: number) => {
    const beam = beamOf(world, pose, { x: x_m, y: y_m, yaw: angle });
    return Math.min(range_m, aheadOf(world, boxes, beam)?.metres ?? range_m);
  };
  const sonar = rings.includes("sonar")
    ? sonars.map(({ x_m, y_m, angle_rad }) => reach(x_m, y_m, angle_rad, sonar_range_m))
    : null;
  const lidar =
    rings.includes("lidar") && laser
      ? Array.from({ length: laser.field_deg + 1 }, (_, degree) => {
          const angle = ((degree - laser.field_deg / 2) * Math.PI) / 180;
          return Math.max(laser.min_m, reach(laser.x_m, laser.y_m, angle, laser.range_m));
        })
      : null;
  return sonar || lidar ? { sonar, lidar } : null;
}

/** The origin and direction of a beam in the world frame; `sensor` is in the robot's frame. */
function beamOf(world: World, pose: Pose, sensor: Pose): Pose {
  const start = startOf(world);
  const onRobot = toWorld(pose, sensor.x, sensor.y);
  return {
    ...toWorld(start, onRobot.x, onRobot.y),
    yaw: start.yaw + pose.yaw + sensor.yaw,
  };
}
