import { signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { RobotStateChangedEvent } from "../../api/model";
import { robotsApi } from "../../api/robots";
import { usePolling } from "../../kit/usePolling";

export type RobotState = RobotStateChangedEvent;

/** The last state that the server sent for each watched robot, by link. */
export const robotStates = signal<Readonly<Record<string, RobotState>>>({});

/** Interval of the requests: the server watches a robot for some seconds after each request. */
const ASK_EACH_MS = 2000;

export function receiveState(state: RobotState): void {
  robotStates.value = { ...robotStates.value, [state.link]: state };
}

/** Watches a robot; null for none. A robot that cannot be watched stays unknown. */
export function useWatchedRobot(link: string | null): void {
  const ask = (isFirst: boolean) => link && robotsApi.watch(link, isFirst).catch(() => {});
  useEffect(() => {
    if (!link) return;
    ask(true);
    return () => {
      const { [link]: _removed, ...others } = robotStates.value;
      robotStates.value = others;
    };
  }, [link]);
  usePolling(() => ask(false), { everyMs: ASK_EACH_MS, isOn: link !== null, evenHidden: true });
}

/** The robot's pose in the room; null while it is unknown. */
export function poseInRoom({ x_m, y_m, heading_deg }: RobotState) {
  return x_m === null || y_m === null || heading_deg === null ? null : { x_m, y_m, heading_deg };
}
