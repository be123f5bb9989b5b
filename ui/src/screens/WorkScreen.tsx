import { useSignal } from "@preact/signals";
import { Plus } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { api } from "../api/client";
import { startProgram } from "../app/entering";
import { couldNotOpen } from "../app/open_program";
import { group, report } from "../app/session";
import { TEST } from "../app/testids";
import { texts } from "../i18n";
import { Letters } from "../notes/Letters";
import { Bin } from "./Bin";
import { GroupHead } from "./GroupHead";
import { NotOpened } from "./NotOpened";
import { ProgramCard } from "./ProgramCard";
import { ProgramShelf } from "./program_shelf";
import { RunCard } from "./RunCard";
import { RunFilters } from "./RunFilters";
import { RunList } from "./run_list";
import { WayBack } from "./WayBack";

/** Everything a group has made: its programs and their runs, as pictures of their paths. */
export function WorkScreen({ groupId }: { groupId: string }) {
  const shelf = useSignal(new ProgramShelf(groupId)).peek();
  const list = useSignal(new RunList(groupId)).peek();
  const failed = useSignal(false);
  const { value: programs } = shelf.programs;
  const { work, keeping } = texts.value;

  useEffect(() => {
    let left = false;
    const load = async () => {
      if (group.value?.id !== groupId) {
        group.value = (await api.groups()).find((one) => one.id === groupId) ?? null;
      }
      await list.load();
      await shelf.load();
    };
    load().catch((error) => {
      if (left) return;
      failed.value = true;
      couldNotOpen(error);
    });
    return () => {
      left = true;
    };
  }, [groupId]);

  const pictureOf = (id: string) =>
    list.runs.value.find((run) => run.program_id === id && run.path.length > 1)?.path ?? [];

  const create = () => startProgram(groupId, [...(programs ?? []), ...shelf.bin.value]);

  if (failed.value) return <NotOpened />;
  if (!programs) return <main class="screen" aria-busy="true" />;
  return (
    <main class="screen work">
      <h1 class="visually-hidden">{work.title(group.value?.name ?? "")}</h1>
      {group.value && <GroupHead key={groupId} group={group.value} />}
      <Letters groupId={groupId} />
      <section>
        <h2 class="work__title">{work.programs}</h2>
        <WayBackFromBin shelf={shelf} />
        <ul class="work__cards">
          <li>
            <button
              type="button"
              class="work__new"
              data-testid={TEST.newProgram}
              onClick={() => void create().catch(report)}
            >
              <Plus class="icon" aria-hidden="true" />
              {work.newProgram}
            </button>
          </li>
          {programs.map((one) => (
            <li key={one.id}>
              <ProgramCard
                program={one}
                path={pictureOf(one.id)}
                onThrowAway={() => void shelf.throwAway(one).catch(report)}
              />
            </li>
          ))}
        </ul>
      </section>
      <section>
        <h2 class="work__title">{work.runs}</h2>
        {list.runs.value.length === 0 ? (
          <div class="work__empty">
            <strong>{work.emptyRunsTitle}</strong>
            <p>{work.emptyRuns}</p>
          </div>
        ) : (
          <RunFilters list={list} programs={[...programs, ...shelf.bin.value]} />
        )}
        {list.runs.value.length > 0 && list.shown.value.length === 0 && (
          <p class="work__empty">{list.next.value ? keeping.noneLikeYet : keeping.noneLike}</p>
        )}
        <ul class="work__cards">
          {list.shown.value.map((run) => (
            <li key={run.id}>
              <RunCard run={run} />
            </li>
          ))}
        </ul>
        {list.next.value && (
          <button
            type="button"
            class="button work__older"
            onClick={() => void list.older().catch(report)}
          >
            {work.older}
          </button>
        )}
      </section>
      <Bin shelf={shelf} />
    </main>
  );
}

function WayBackFromBin({ shelf }: { shelf: ProgramShelf }) {
  const { value: thrown } = shelf.thrown;
  if (!thrown) return null;
  const { keeping } = texts.value;
  return (
    <div class="work__thrown">
      <WayBack
        words={keeping.thrown(thrown.name)}
        action={keeping.undo}
        testId={TEST.throwBack}
        onBack={() => void shelf.takeBack(thrown).catch(report)}
        onClose={() => {
          shelf.thrown.value = null;
        }}
      />
    </div>
  );
}
