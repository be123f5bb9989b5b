import { CircleCheck, CircleStop, CircleX, LoaderCircle } from "lucide-preact";
import type { Run } from "../api/model";
import { language, texts } from "../i18n";
import { duration, relativeDateAndTime } from "../i18n/format";
import { RobotName } from "../run/real/RobotName";
import { PathPicture } from "../scene/small/PathPicture";
import { hashOf } from "../shell/route";

const ICONS = {
  running: LoaderCircle,
  finished: CircleCheck,
  stopped: CircleStop,
  failed: CircleX,
} as const;

/** A live run opens in the studio, a finished one in the replay. */
function hrefOf(run: Run): string {
  if (run.state === "running" && run.program_id) {
    return hashOf({ screen: "studio", program: run.program_id });
  }
  return hashOf({ screen: "replay", run: run.id });
}

export function RunCard({ run }: { run: Run }) {
  const { work } = texts.value;
  const Icon = ICONS[run.state];
  const state = run.passed ? work.passed : work.states[run.state];
  const facts = [
    relativeDateAndTime(run.started_at, new Date(), language.value, texts.value),
    run.duration_s === null ? null : duration(run.duration_s, language.value),
  ];
  return (
    <a class="work-card card" href={hrefOf(run)} data-testid="run-card" data-state={run.state}>
      <span class="visually-hidden">{work.replay}: </span>
      <span class="work-card__picture">
        <PathPicture path={run.path} failed={run.state === "failed"} />
      </span>
      <span class="work-card__words">
        <span class={`work-card__state work-card__state--${run.state}`}>
          <Icon class="icon" aria-hidden="true" />
          {state}
        </span>
        <span class="work-card__line work-card__line--strong">
          {run.program_name ?? work.noName}
        </span>
        <RobotName link={run.link} calibrated={run.calibrated_robot} />
        <span class="work-card__line work-card__line--facts">
          {facts.filter(Boolean).join(" · ")}
        </span>
      </span>
    </a>
  );
}
