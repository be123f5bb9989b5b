import { History, Trash2 } from "lucide-preact";
import type { Program } from "../api/model";
import { language, texts } from "../i18n";
import { relativeTime } from "../i18n/format";
import { changedText, labelled } from "../i18n/phrases";
import { Button } from "../kit/Button";
import { LinkButton } from "../kit/LinkButton";
import { PathPicture } from "../scene/small/PathPicture";
import { PresentButton } from "../shell/projector/PresentButton";
import { hashOf } from "../shell/route";
import { teacherSession } from "../shell/teacher/teacher_session";
import { ExportProgram } from "./ProgramFile";

interface ProgramCardProps {
  program: Program;
  /** Path of the program's newest run. */
  path: readonly (readonly number[])[];
  onThrowAway(): Promise<void>;
}

export function ProgramCard({ program, path, onThrowAway }: ProgramCardProps) {
  const { work, archive, projector } = texts.value;
  const changed = relativeTime(program.updated_at, new Date(), language.value, texts.value);
  const about = (label: string) => labelled(label, program.name);
  return (
    <div class="program-card card column shrinks">
      <a
        class="work-card"
        href={hashOf({ screen: "studio", program: program.id })}
        data-testid="program-card"
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
          <span class="work-card__line work-card__line--facts">
            {changedText(changed, texts.value)}
          </span>
          <span class="work-card__line">{work.runCount({ count: program.n_runs })}</span>
        </span>
      </a>
      <div class="program-card__acts row rigid">
        <LinkButton
          kind="plain"
          icon={History}
          href={hashOf({ screen: "versions", program: program.id, version: null })}
          label={about(archive.history)}
          testId="open-history"
        >
          {archive.history}
        </LinkButton>
        <ExportProgram program={program} />
        <Button
          kind="plain"
          icon={Trash2}
          label={about(archive.throwAway)}
          testId="throw-away"
          onPress={onThrowAway}
        >
          {archive.throwAway}
        </Button>
        {teacherSession.value?.is_open && (
          <PresentButton program={program.id}>{projector.short}</PresentButton>
        )}
      </div>
    </div>
  );
}
