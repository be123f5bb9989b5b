import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { api } from "../api/client";
import type { Group } from "../api/model";
import { enterGroup } from "../app/entering";
import { report } from "../app/session";
import { TEST } from "../app/testids";
import { texts } from "../i18n";
import { PathPicture } from "../scene/PathPicture";

/** Of so many runs, the newest that went anywhere makes the picture. */
const LOOKED_AT = 8;

/** A group by name, colour and the path of its newest run. */
export function GroupCard({ group }: { group: Group }) {
  const { start } = texts.value;
  const path = useSignal<readonly (readonly number[])[]>([]);
  useEffect(() => {
    if (group.n_runs === 0) return;
    api.runs(group.id, null, LOOKED_AT).then(({ runs }) => {
      path.value = runs.find((run) => run.path.length > 1)?.path ?? [];
    }, report);
  }, [group.id]);
  const made = [start.programs(group.n_programs), start.runs(group.n_runs)];
  const counts = group.n_programs === 0 ? start.nothingYet : made.join(" · ");
  return (
    <button
      type="button"
      class="group-card card tinted"
      style={{ "--group": group.color }}
      data-testid={TEST.groupCard}
      aria-label={start.open(group.name)}
      onClick={() => void enterGroup(group).catch(report)}
    >
      <span class="group-card__picture">
        <PathPicture path={path.value} />
      </span>
      <span class="group-card__words">
        <span class="group-card__name">{group.name}</span>
        <span class="group-card__counts">{counts}</span>
      </span>
    </button>
  );
}
