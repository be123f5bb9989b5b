import { Plus } from "lucide-preact";
import { api } from "../api/client";
import type { Program } from "../api/model";
import { texts } from "../i18n";
import { Button } from "../kit/Button";
import { Loaded } from "../kit/requests/Loaded";
import { useLoaded } from "../kit/requests/useLoaded";
import { WayBack } from "../kit/WayBack";
import type { ParametersOf } from "../shell/route";
import { group } from "../shell/session";
import { couldNotOpen } from "../studio/program/open_program";
import { Bin } from "./Bin";
import { startProgram } from "./entering";
import { GroupHead } from "./GroupHead";
import { ProgramCard } from "./ProgramCard";
import { ProgramShelf } from "./program_shelf";
import { RunCard } from "./RunCard";
import { RunFilters } from "./RunFilters";
import { RunList } from "./run_list";
import { UnreadNotes } from "./UnreadNotes";

/** A group's programs and runs, loaded together. */
class GroupWork {
  readonly shelf: ProgramShelf;
  readonly runs: RunList;

  constructor(readonly groupId: string) {
    this.shelf = new ProgramShelf(groupId);
    this.runs = new RunList(groupId);
  }

  async load(): Promise<GroupWork> {
    if (group.value?.id !== this.groupId) {
      group.value = (await api.groups()).find((one) => one.id === this.groupId) ?? null;
    }
    await this.runs.load();
    await this.shelf.load();
    return this;
  }

  get programs(): readonly Program[] {
    return [...this.shelf.programs.value, ...this.shelf.bin.value];
  }
}

/** A group's programs and runs, with pictures of their paths. */
export function WorkScreen({ group: groupId }: ParametersOf<"work">) {
  const work = useLoaded(groupId, () => new GroupWork(groupId).load(), { onFailed: couldNotOpen });
  return (
    <Loaded of={work} as="screen">
      {(made) => (
        <main class="screen work">
          <h1 class="visually-hidden">{texts.value.work.title(group.value?.name ?? "")}</h1>
          {group.value && <GroupHead key={groupId} group={group.value} />}
          <UnreadNotes groupId={groupId} />
          <Programs work={made} />
          <Runs work={made} />
          <Bin shelf={made.shelf} />
        </main>
      )}
    </Loaded>
  );
}

function Programs({ work }: { work: GroupWork }) {
  const words = texts.value.work;
  const { shelf, runs } = work;
  const pictureOf = (id: string) =>
    runs.runs.value.find((run) => run.program_id === id && run.path.length > 1)?.path ?? [];
  return (
    <section>
      <h2 class="work__title">{words.programs}</h2>
      <WayBackFromBin shelf={shelf} />
      <ul class="work__cards">
        <li>
          <Button
            kind="bare"
            class="work__new column middle center gap-2"
            icon={Plus}
            testId="new-program"
            onPress={() => startProgram(work.groupId, work.programs)}
          >
            {words.newProgram}
          </Button>
        </li>
        {shelf.programs.value.map((one) => (
          <li key={one.id}>
            <ProgramCard
              program={one}
              path={pictureOf(one.id)}
              onThrowAway={() => shelf.throwAway(one)}
            />
          </li>
        ))}
      </ul>
    </section>
  );
}

function Runs({ work }: { work: GroupWork }) {
  const { work: words, keeping } = texts.value;
  const { runs: list } = work;
  const { value: shown } = list.shown;
  const isEmpty = list.runs.value.length === 0;
  return (
    <section>
      <h2 class="work__title">{words.runs}</h2>
      {isEmpty ? (
        <div class="work__empty">
          <strong>{words.emptyRunsTitle}</strong>
          <p>{words.emptyRuns}</p>
        </div>
      ) : (
        <RunFilters list={list} programs={work.programs} />
      )}
      {!isEmpty && shown.length === 0 && (
        <p class="work__empty">{list.next.value ? keeping.noneLikeYet : keeping.noneLike}</p>
      )}
      <ul class="work__cards">
        {shown.map((run) => (
          <li key={run.id}>
            <RunCard run={run} />
          </li>
        ))}
      </ul>
      {list.next.value && (
        <Button class="work__older" onPress={() => list.older()}>
          {words.older}
        </Button>
      )}
    </section>
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
        testId="throw-back"
        onBack={() => shelf.takeBack(thrown)}
        onClose={() => {
          shelf.thrown.value = null;
        }}
      />
    </div>
  );
}
