import { useSignal } from "@preact/signals";
import { ApiError } from "../api/errors";
import type { Activity } from "../api/model";
import { levelNeeded } from "../blocks/toolbox/level_needed";
import { chooseSigns } from "../camera/signs";
import { texts } from "../i18n";
import { Loaded } from "../kit/requests/Loaded";
import { useLoaded } from "../kit/requests/useLoaded";
import { ToStart } from "../kit/ToStart";
import { clear, live, liveRun } from "../run/live";
import { loadRealRobots } from "../run/real/real_robot";
import { isLive } from "../run/reducer";
import { programAndGroups } from "../shell/first_answers";
import { LEVELS, levelInUse, type MissionLevel, missionLevel } from "../shell/level";
import type { ParametersOf } from "../shell/route";
import { group, problem, program, report } from "../shell/session";
import { OpenLastIntact } from "./OpenLastIntact";
import { couldNotOpen, OpenProgram, opened, reloads } from "./program/open_program";
import { Studio } from "./Studio";

/** Loads a program and shows it in the studio. */
export function StudioScreen({ program: programId }: ParametersOf<"studio">) {
  return <Opening key={`${programId} ${reloads.value}`} programId={programId} />;
}

function Opening({ programId }: { programId: string }) {
  const lastIntact = useSignal(false);
  const opening = useLoaded(
    [programId, lastIntact.value],
    (signal) => open(programId, lastIntact.peek(), signal),
    { onFailed: couldNotOpen, release: (left) => left.close() },
  );
  const lastIntactAt = opening.status === "failed" ? timeOfLastIntact(opening.error) : null;
  const openLastIntact = () => {
    problem.value = null; // the problem advised to open this version
    lastIntact.value = true;
  };
  const actions = lastIntactAt && (
    <>
      <OpenLastIntact at={lastIntactAt} onPress={openLastIntact} />
      <ToStart />
    </>
  );
  return (
    <Loaded
      of={opening}
      as="screen"
      loading={texts.value.studio.opening}
      {...(actions ? { actions } : {})}
    >
      {(made) => <Studio open={made} />}
    </Loaded>
  );
}

/** Time of the last intact version, if `error` reports a damaged newest version; else null. */
function timeOfLastIntact(error: unknown): string | null {
  const isDamaged = error instanceof ApiError && error.code === "version_damaged";
  return isDamaged && error.params.sound ? String(error.params.sound_time) : null;
}

async function open(
  programId: string,
  lastIntact: boolean,
  signal: AbortSignal,
): Promise<OpenProgram> {
  const [loaded, groups] = await programAndGroups(programId, lastIntact);
  signal.throwIfAborted();
  group.value = groups.find((one) => one.id === loaded.group_id) ?? null;
  program.value = loaded;
  levelInUse.value = levelNeeded(loaded.version?.workspace);
  void loadRealRobots().catch(report);
  void chooseSigns(group.value?.classroom_id ?? null);
  const made = new OpenProgram(loaded);
  await made.loadMission();
  signal.throwIfAborted();
  missionLevel.value = levelOf(programId, made.mission.peek());
  opened.value = made;
  forgetOtherRun(programId);
  return opened.value;
}

/** What a mission sets for the toolbox. */
function levelOf(program: string, mission: Activity | null): MissionLevel | null {
  if (!mission) return null;
  const level = LEVELS.find((one) => one === mission.level) ?? null;
  return { program, level, blocks: mission.blocks };
}

/** Clears the last run from the floor if it belongs to another program. */
function forgetOtherRun(programId: string): void {
  if (!isLive(live.value) && liveRun.value?.program_id !== programId) clear();
}
