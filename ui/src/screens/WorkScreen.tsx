import { useSignal } from "@preact/signals";
import { Plus } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { api } from "../api/client";
import type { Program, Run } from "../api/model";
import { createProgram } from "../app/entering";
import { go } from "../app/route";
import { group, program, report } from "../app/session";
import { TEST } from "../app/testids";
import { texts } from "../i18n";
import { GroupHead } from "./GroupHead";
import { ProgramCard } from "./ProgramCard";
import { RunCard } from "./RunCard";
import "./work.css";

/** Everything a group has made: its programs and their runs, as pictures of their paths. */
export function WorkScreen({ groupId }: { groupId: string }) {
  const programs = useSignal<Program[] | null>(null);
  const runs = useSignal<Run[]>([]);
  const next = useSignal<string | null>(null);
  const { work } = texts.value;

  const older = async (before: string | null) => {
    const page = await api.runs(groupId, before);
    runs.value = [...runs.value, ...page.runs];
    next.value = page.next;
  };

  useEffect(() => {
    const load = async () => {
      if (group.value?.id !== groupId) {
        group.value = (await api.groups()).find((one) => one.id === groupId) ?? null;
      }
      await older(null);
      programs.value = await api.programs(groupId);
    };
    load().catch(report);
  }, [groupId]);

  const pictureOf = (id: string) =>
    runs.value.find((run) => run.program_id === id && run.path.length > 1)?.path ?? [];

  const create = async () => {
    const made = await createProgram(groupId, programs.value ?? []);
    program.value = made;
    go({ screen: "studio", program: made.id });
  };

  if (!programs.value) return <main class="screen" aria-busy="true" />;
  return (
    <main class="screen work">
      <h1 class="visually-hidden">{work.title(group.value?.name ?? "")}</h1>
      {group.value && <GroupHead key={groupId} group={group.value} />}
      <section>
        <h2 class="work__title">{work.programs}</h2>
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
          {programs.value.map((one) => (
            <li key={one.id}>
              <ProgramCard program={one} path={pictureOf(one.id)} />
            </li>
          ))}
        </ul>
      </section>
      <section>
        <h2 class="work__title">{work.runs}</h2>
        {runs.value.length === 0 && (
          <div class="work__empty">
            <strong>{work.emptyRunsTitle}</strong>
            <p>{work.emptyRuns}</p>
          </div>
        )}
        <ul class="work__cards">
          {runs.value.map((run) => (
            <li key={run.id}>
              <RunCard run={run} />
            </li>
          ))}
        </ul>
        {next.value && (
          <button
            type="button"
            class="button work__older"
            onClick={() => void older(next.value).catch(report)}
          >
            {work.older}
          </button>
        )}
      </section>
    </main>
  );
}
