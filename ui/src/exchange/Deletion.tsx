import { ChevronDown, Trash2 } from "lucide-preact";
import type { ComponentChildren, Ref } from "preact";
import { useState } from "preact/hooks";
import { exchange, type Removed } from "../api/exchange";
import type { Classroom, Group } from "../api/model";
import { TEST } from "../app/testids";
import { texts } from "../i18n";
import { useAct } from "../teacher/act";
import { FaultLine } from "../teacher/FaultLine";
import { words } from "./words";

interface Properties {
  classroom: Classroom | undefined;
  groups: readonly Group[];
  onDone(removed: Removed): Promise<void>;
  /** What was deleted just now. */
  children?: ComponentChildren;
}

/** A group, or the whole class, for good: what goes is said before. */
export function Deletion({ classroom, groups, onDone, children }: Properties) {
  const [chosen, setChosen] = useState("");
  const { busy, fault, act } = useAct();
  const { deletion } = words.value;
  const doomed = chosen === classroom?.id ? groups : groups.filter(({ id }) => id === chosen);
  const name = chosen === classroom?.id ? classroom.name : (doomed[0]?.name ?? "");

  const go = () =>
    act(async () => {
      const isClass = chosen === classroom?.id;
      const removed = await (isClass ? exchange.deleteClassroom : exchange.deleteGroup)(chosen);
      setChosen("");
      await onDone(removed);
    });

  return (
    <details class="deletion">
      <summary data-testid={TEST.deletionOpen}>
        <Trash2 class="icon" aria-hidden="true" />
        {deletion.title}
      </summary>
      <p class="exchange__none">{deletion.hint}</p>
      <span class="select deletion__what">
        <select
          aria-label={deletion.what}
          data-testid={TEST.deletionWhat}
          value={chosen}
          onChange={({ currentTarget }) => setChosen(currentTarget.value)}
        >
          <option value="">{deletion.nothing}</option>
          {groups.map((one) => (
            <option key={one.id} value={one.id}>
              {deletion.group(one.name)}
            </option>
          ))}
          {classroom && <option value={classroom.id}>{deletion.classroom(classroom.name)}</option>}
        </select>
        <ChevronDown class="icon icon--end" aria-hidden="true" />
      </span>
      {chosen && (
        <div class="deletion__sure">
          <p>
            <Goes name={name} groups={doomed} />
          </p>
          <div class="exchange__buttons">
            <button
              type="button"
              class="button button--stop"
              data-testid={TEST.deletionGo}
              disabled={busy}
              onClick={() => void go()}
            >
              {deletion.go}
            </button>
            <button type="button" class="button" onClick={() => setChosen("")}>
              {deletion.cancel}
            </button>
          </div>
        </div>
      )}
      <FaultLine fault={fault} />
      {children}
    </details>
  );
}

function Goes({ name, groups }: { name: string; groups: readonly Group[] }) {
  const say = words.value;
  const total = (count: (group: Group) => number) =>
    groups.reduce((sum, group) => sum + count(group), 0);
  const inBin = total((group) => group.n_in_bin);
  const all = say.programs(total((group) => group.n_programs) + inBin);
  const programs = inBin > 0 ? `${all} (${texts.value.start.alsoInBin(inBin)})` : all;
  const runs = say.runs(total((group) => group.n_runs));
  return <>{say.deletion.goes(name, programs, runs)}</>;
}

interface GoneProperties {
  removed: Removed;
  answer: Ref<HTMLDivElement>;
}

/** What is gone, and where it may still be. */
export function Gone({ removed, answer }: GoneProperties) {
  const say = words.value;
  const left = [...removed.files.map(({ path }) => path), ...removed.backups];
  const { n_groups, n_programs, n_runs } = removed;
  return (
    <div
      ref={answer}
      class="deletion__done"
      role="status"
      tabIndex={-1}
      data-testid={TEST.deletionDone}
    >
      <p>{say.deletion.done(say.groups(n_groups), say.programs(n_programs), say.runs(n_runs))}</p>
      <StillIn paths={left} />
    </div>
  );
}

/** Files that people have to delete by hand. */
export function StillIn({ paths }: { paths: readonly string[] }) {
  if (paths.length === 0) return null;
  return (
    <>
      <p>{words.value.deletion.left}</p>
      <ul>
        {paths.map((path) => (
          <li key={path}>{path}</li>
        ))}
      </ul>
    </>
  );
}
