import { signal } from "@preact/signals";
import type { RobotStateToldEvent } from "../../api/model";
import { robotsApi } from "../../api/robots";

export type RobotState = RobotStateToldEvent;

/** What the server told last of each watched robot, by link. */
export const robotStates = signal<Readonly<Record<string, RobotState>>>({});

/** The server listens for some seconds after each request. */
const ASK_EACH_MS = 2000;

export function receiveState(state: RobotState): void {
  robotStates.value = { ...robotStates.value, [state.link]: state };
}

/** Watches a robot until the returned function is called. A robot that cannot be watched stays unknown. */
export function watchRobot(link: string): () => void {
  let isFirst = true;
  const ask = () => {
    robotsApi.watch(link, isFirst).catch(() => {});
    isFirst = false;
  };
  ask();
  const timer = setInterval(ask, ASK_EACH_MS);
  return () => {
    clearInterval(timer);
    const { [link]: _gone, ...others } = robotStates.value;
    robotStates.value = others;
  };
}

/** Its place in the room; null while nobody knows. */
export function placeOf({ x_m, y_m, heading_deg }: RobotState) {
  return x_m === null || y_m === null || heading_deg === null ? null : { x_m, y_m, heading_deg };
}
