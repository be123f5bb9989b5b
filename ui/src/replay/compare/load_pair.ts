import { api } from "../../api/client";
import type { Group, RunWithVersion, VersionDifference } from "../../api/model";
import { versionsApi } from "../../api/versions";
import { report } from "../../shell/session";
import { ComparedBlocks } from "../../versions/compared_blocks";
import type { ComparedWorkspaces } from "../../versions/differences";
import { loadRecordedRun } from "../recorded_run";
import { Pair } from "./pair";

export type PairBlocks = ComparedBlocks<ComparedWorkspaces>;

/** Two runs, loaded for a comparison side by side. */
export interface LoadedPair {
  readonly pair: Pair;
  readonly groups: readonly Group[];
  /** Null if the version of one run is not stored. */
  readonly blocks: PairBlocks | null;
  /**
   * Whether both runs are of one program. Blocks are compared by id, which different programs do
   * not share.
   */
  readonly isOneProgram: boolean;
}

const NOTHING_DIFFERS: VersionDifference = { added: [], removed: [], changed: [], moved: [] };

export async function loadPair(first: string, second: string): Promise<LoadedPair> {
  const [one, other, groups] = await Promise.all([
    loadRecordedRun(first),
    loadRecordedRun(second),
    api.groups(),
  ]);
  const isOneProgram = one.run.program_id !== null && one.run.program_id === other.run.program_id;
  const blocks = await blocksOf(one.run, other.run, isOneProgram);
  return { pair: new Pair(one, other), groups, blocks, isOneProgram };
}

async function blocksOf(
  { version: before }: RunWithVersion,
  { version: after }: RunWithVersion,
  isOneProgram: boolean,
): Promise<PairBlocks | null> {
  if (!before || !after) return null;
  const differ = isOneProgram && before.id !== after.id;
  const difference = differ
    ? await versionsApi.difference(before.id, after.id).catch((error) => {
        report(error);
        return NOTHING_DIFFERS;
      })
    : NOTHING_DIFFERS;
  return new ComparedBlocks<ComparedWorkspaces>({ before, after, difference });
}
