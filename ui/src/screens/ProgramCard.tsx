import type { Program } from "../api/model";
import { hashOf } from "../app/route";
import { TEST } from "../app/testids";
import { language, texts } from "../i18n";
import { when } from "../i18n/format";
import { PathPicture } from "../scene/PathPicture";

interface ProgramCardProps {
  program: Program;
  /** Of its newest run. */
  path: readonly (readonly number[])[];
}

export function ProgramCard({ program, path }: ProgramCardProps) {
  const { work } = texts.value;
  const changed = when(program.updated_at, new Date(), language.value, texts.value);
  return (
    <a
      class="work-card card"
      href={hashOf({ screen: "studio", program: program.id })}
      data-testid={TEST.programCard}
      aria-label={`${work.open}: ${program.name}`}
    >
      <span class="work-card__picture">
        <PathPicture path={path} />
        {path.length < 2 && <span class="work-card__none">{work.emptyProgram}</span>}
      </span>
      <span class="work-card__words">
        <span class="work-card__name">{program.name}</span>
        <span class="work-card__line">{work.changed(changed)}</span>
        <span class="work-card__line">{work.runCount(program.n_runs)}</span>
      </span>
    </a>
  );
}
