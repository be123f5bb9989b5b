import type { Activity } from "../api/model";
import { levelNeeded } from "../blocks/toolbox/level_needed";
import { chooseSigns } from "../camera/signs";
import { texts } from "../i18n";
import { Loaded } from "../kit/requests/Loaded";
import { useLoaded } from "../kit/requests/useLoaded";
import { clear, live, liveRun } from "../run/live";
import { loadRealRobots } from "../run/real/real_robot";
import { isLive } from "../run/reducer";
import { programAndGroups } from "../shell/first_answers";
import { LEVELS, levelInUse, type MissionLevel, missionLevel } from "../shell/level";
import { group, program, report } from "../shell/session";
import { couldNotOpen, OpenProgram, opened, reloads } from "./program/open_program";
import { Studio } from "./Studio";

/** Loads a program and shows it in the studio. */
export function StudioScreen({ program: programId }: { program: string }) {
  return <Opening key={`${programId} ${reloads.value}`} programId={programId} />;
}

function Opening({ programId }: { programId: string }) {
  const opening = useLoaded(programId, (signal) => open(programId, signal), {
    onFailed: couldNotOpen,
    release: (left) => left.close(),
  });
  return (
    <Loaded of={opening} as="screen" loading={texts.value.studio.opening}>
      {(made) => <Studio open={made} />}
    </Loaded>
  );
}

async function open(programId: string, signal: AbortSignal): Promise<OpenProgram> {
  const [loaded, groups] = await programAndGroups(programId);
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

/** What a mission says of the toolbox. */
function levelOf(program: string, mission: Activity | null): MissionLevel | null {
  if (!mission) return null;
  const level = LEVELS.find((one) => one === mission.level) ?? null;
  return { program, level, blocks: mission.blocks };
}

/** Clears the last run from the floor if it is of another program. */
function forgetOtherRun(programId: string): void {
  if (!isLive(live.value) && liveRun.value?.program_id !== programId) clear();
}
