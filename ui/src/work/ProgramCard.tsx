import { History, Trash2 } from "lucide-preact";
import type { Program } from "../api/model";
import { hashOf } from "../app/route";
import { TEST } from "../app/testids";
import { language, texts } from "../i18n";
import { when } from "../i18n/format";
import { PathPicture } from "../scene/PathPicture";
import { TakeAlong } from "./ProgramFile";

interface ProgramCardProps {
  program: Program;
  /** Of its newest run. */
  path: readonly (readonly number[])[];
  onThrowAway(): void;
}

export function ProgramCard({ program, path, onThrowAway }: ProgramCardProps) {
  const { work, keeping } = texts.value;
  const changed = when(program.updated_at, new Date(), language.value, texts.value);
  const about = (words: string) => `${words}: ${program.name}`;
  return (
    <div class="program-card card">
      <a
        class="work-card"
        href={hashOf({ screen: "studio", program: program.id })}
        data-testid={TEST.programCard}
      >
        <span class="visually-hidden">{work.open}: </span>
        <span class="work-card__picture">
          <PathPicture path={path} />
          {path.length < 2 && <span class="work-card__none">{work.emptyProgram}</span>}
        </span>
        <span class="work-card__words">
          <span class="work-card__name" dir="auto">
            {program.name}
          </span>
          <span class="work-card__line work-card__line--facts">{work.changed(changed)}</span>
          <span class="work-card__line">{work.runCount(program.n_runs)}</span>
        </span>
      </a>
      <div class="program-card__acts">
        <a
          class="button button--plain"
          href={hashOf({ screen: "versions", program: program.id, version: null })}
          data-testid={TEST.openHistory}
          aria-label={about(keeping.history)}
        >
          <History class="icon" aria-hidden="true" />
          {keeping.history}
        </a>
        <TakeAlong program={program} />
        <button
          type="button"
          class="button button--plain"
          data-testid={TEST.throwAway}
          aria-label={about(keeping.throwAway)}
          onClick={onThrowAway}
        >
          <Trash2 class="icon" aria-hidden="true" />
          {keeping.throwAway}
        </button>
      </div>
    </div>
  );
}
