import { Group, MeshBasicMaterial } from "three";
import type { Robot } from "../../api/model";
import type { Pose, RunView } from "../../run/reducer";
import type { Point } from "../../run/trail";
import type { Colours } from "../colours";
import { extentOf, hullCorners } from "../hull";
import { OFF_M } from "../renderer";
import { Ribbon } from "./ribbon";

/** The pose that the robot estimates, as a dashed outline on the floor; only where it differs from the true one. */
export class Belief {
  readonly group = new Group();
  private readonly material = new MeshBasicMaterial({ vertexColors: true, depthWrite: false });
  private readonly outline: Ribbon;

  constructor(robot: Robot, colours: Colours) {
    this.outline = new Ribbon(this.material, { width: 0.016, z: 0.008, dash: [0.04, 0.03] });
    const corners = hullCorners(robot).flatMap(({ into, out }): Point[] => [
      [into.x, into.y],
      [out.x, out.y],
    ]);
    this.outline.append([...corners, ...corners.slice(0, 1)], colours.number);
    this.outline.append(
      [
        [0, 0],
        [extentOf(robot).front, 0],
      ],
      colours.number,
    );
    this.outline.upload();
    this.group.add(this.outline.mesh);
  }

  show({ pose, truth }: RunView, at: Pose): void {
    const [dx, dy] = [pose.x - truth.x, pose.y - truth.y];
    this.group.visible = Math.hypot(dx, dy) >= OFF_M;
    this.group.position.set(at.x + dx, at.y + dy, 0);
    this.group.rotation.z = at.yaw + pose.yaw - truth.yaw;
  }

  dispose(): void {
    this.outline.dispose();
    this.material.dispose();
    this.group.removeFromParent();
  }
}
