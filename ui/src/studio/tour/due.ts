import { TOUR_OVER, tourSteps } from "../../shell/help";
import { group } from "../../shell/session";
import type { OpenProgram } from "../program/open_program";

/** Whether the guided first drive is due in a program: once, to a group of pupils without work, or until it is over. */
export function isTourDue(open: OpenProgram): boolean {
  if (group.peek()?.of_teacher) return false;
  const storedStep = tourSteps.of(open.program.group_id);
  return storedStep === null ? isNew(open) : storedStep !== TOUR_OVER;
}

/** The program of a mission has a version before the group has put a block. */
function isNew(open: OpenProgram): boolean {
  const { n_programs = 0, n_in_bin = 0, n_runs = 0 } = group.peek() ?? {};
  const isUntouched = open.mission.peek() ? open.isEmpty : !open.program.version;
  return n_programs <= 1 && n_in_bin === 0 && n_runs === 0 && isUntouched;
}
