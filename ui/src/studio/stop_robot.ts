import { effect } from "@preact/signals";
import { ApiError } from "../api/errors";
import * as robot from "../run/live";
import { isLive } from "../run/reducer";
import { problem, report } from "../shell/session";

/** Stops the live run; reports failures. */
export function stopRobot(): void {
  robot.stop().catch((error) => {
    report(error);
    // `real_stop_unconfirmed` stays: somebody must look at the real robot
    if (error instanceof ApiError && error.code === "stop_unconfirmed") forgetWhenOver();
  });
}

/** Closes the shown problem once the run has ended for any reason. */
function forgetWhenOver(): void {
  const { value: shownProblem } = problem;
  const stop = effect(() => {
    if (isLive(robot.live.value)) return;
    if (problem.peek() === shownProblem) problem.value = null;
    queueMicrotask(() => stop());
  });
}
