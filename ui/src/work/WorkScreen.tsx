import { Plus } from "lucide-preact";
import { api } from "../api/client";
import type { Program } from "../api/model";
import { texts } from "../i18n";
import { Button } from "../kit/Button";
import { Loaded } from "../kit/requests/Loaded";
import { useLoaded } from "../kit/requests/useLoaded";
import { UndoBanner } from "../kit/UndoBanner";
import { liveryOf } from "../scene/livery/livery";
import { liveryStyle } from "../scene/livery/RobotPicture";
import type { ParametersOf } from "../shell/route";
import { group } from "../shell/session";
import { couldNotOpen } from "../studio/program/open_program";
import { Bin } from "./Bin";
import { startProgram } from "./entering";
import { GroupHead } from "./GroupHead";
import { ProgramCard } from "./ProgramCard";
import { ProgramCollection } from "./program_collection";
import { RunCard } from "./RunCard";
import { RunFilters } from "./RunFilters";
import { RunList } from "./run_list";
import { UnreadNotes } from "./UnreadNotes";

/** A group's programs and runs, loaded together. */
class GroupWork {
  readonly collection: ProgramCollection;
  readonly runs: RunList;

  constructor(readonly groupId: string) {
    this.collection = new ProgramCollection(groupId);
    this.runs = new RunList(groupId);
  }

  async load(): Promise<GroupWork> {
    if (group.value?.id !== this.groupId) {
      group.value = (await api.groups()).find((one) => one.id === this.groupId) ?? null;
    }
    await this.runs.load();
    await this.collection.load();
    return this;
  }

  get programs(): readonly Program[] {
    return [...this.collection.programs.value, ...this.collection.bin.value];
  }
}

/** A group's programs and runs, with pictures of their paths. */
export function WorkScreen({ group: groupId }: ParametersOf<"work">) {
  const work = useLoaded(groupId, () => new GroupWork(groupId).load(), { onFailed: couldNotOpen });
  return (
    <Loaded of={work} as="screen">
      {(made) => (
        <main class="screen work" style={liveryStyle(liveryOf(group.value))}>
          <h1 class="visually-hidden">
            {texts.value.work.title({ group: group.value?.name ?? "" })}
          </h1>
          {group.value && <GroupHead key={groupId} group={group.value} />}
          <UnreadNotes groupId={groupId} />
          <Programs work={made} />
          <Runs work={made} />
          <Bin collection={made.collection} />
        </main>
      )}
    </Loaded>
  );
}

function Programs({ work }: { work: GroupWork }) {
  const labels = texts.value.work;
  const { collection, runs } = work;
  const pictureOf = (id: string) =>
    runs.runs.value.find((run) => run.program_id === id && run.path.length > 1)?.path ?? [];
  return (
    <section>
      <h2 class="work__title">{labels.programs}</h2>
      <DiscardUndo collection={collection} />
      <ul class="work__cards">
        <li>
          <Button
            kind="bare"
            class="work__new column middle center gap-2"
            icon={Plus}
            testId="new-program"
            onPress={() => startProgram(work.groupId, work.programs)}
          >
            {labels.newProgram}
          </Button>
        </li>
        {collection.programs.value.map((one) => (
          <li key={one.id}>
            <ProgramCard
              program={one}
              path={pictureOf(one.id)}
              onThrowAway={() => collection.throwAway(one)}
            />
          </li>
        ))}
      </ul>
    </section>
  );
}

function Runs({ work }: { work: GroupWork }) {
  const { work: labels, archive } = texts.value;
  const { runs: list } = work;
  const { value: shown } = list.shown;
  const isEmpty = list.runs.value.length === 0;
  return (
    <section>
      <h2 class="work__title">{labels.runs}</h2>
      {isEmpty ? (
        <div class="work__empty">
          <strong>{labels.emptyRunsTitle}</strong>
          <p>{labels.emptyRuns}</p>
        </div>
      ) : (
        <RunFilters list={list} programs={work.programs} />
      )}
      {!isEmpty && shown.length === 0 && (
        <p class="work__empty">{list.next.value ? archive.noneLikeYet : archive.noneLike}</p>
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
          {labels.older}
        </Button>
      )}
    </section>
  );
}

function DiscardUndo({ collection }: { collection: ProgramCollection }) {
  const { value: thrown } = collection.thrown;
  if (!thrown) return null;
  const { archive } = texts.value;
  return (
    <div class="work__thrown">
      <UndoBanner
        text={archive.thrown({ program: thrown.name })}
        action={archive.undo}
        testId="throw-back"
        onBack={() => collection.restore(thrown)}
        onClose={() => {
          collection.thrown.value = null;
        }}
      />
    </div>
  );
}
