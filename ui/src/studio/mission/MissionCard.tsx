import { useSignal } from "@preact/signals";
import { ChevronDown, ChevronUp, CircleCheck, Lightbulb, LocateFixed, Target } from "lucide-preact";
import { useEffect } from "preact/hooks";
import type { Activity, CheckProgress } from "../../api/model";
import { language, texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { checksOf, verdictOf } from "../../run/judgement";
import * as robot from "../../run/live";
import { GoalPicture } from "../../scene/small/GoalPicture";
import { checkStatus, judged, report } from "../../shell/session";
import type { StudioControl } from "../studio_control";
import { CasesTried } from "./CasesTried";
import { CheckList } from "./CheckList";
import { HowJudged } from "./HowJudged";
import { Success } from "./Success";

/** The mission of the group: picture of the goal, story, check list, hints. Folds to one line. */
export function MissionCard({ control }: { control: StudioControl }) {
  const { open } = control;
  const folded = useSignal(false);
  useEffect(() => {
    open.loadMission().catch(report); // the server sends its texts in the language of the page
  }, [open, language.value]);
  const { value: mission } = open.mission;
  const { value: setup } = open.setup;
  if (!mission) return setup.activity ? <UnknownMission /> : null;
  const run = control.mine.value ? robot.live.value.run : null;
  const verdict = verdictOf(run, judged.value);
  const checks = checksOf(mission, verdict?.not_judged ? null : run, checkStatus.value);
  const done = verdict?.passed === true;
  return (
    <section
      class="mission row top gap-4"
      aria-label={texts.value.activity.mission}
      data-testid="mission"
      data-done={done}
    >
      {!folded.value && <GoalPicture goal={mission.goal_picture} />}
      <div class="mission__words">
        <MissionHead mission={mission} done={done} checks={folded.value ? checks : null} />
        {done && <Success open={open} mission={mission} />}
        {!folded.value && (
          <>
            <HowJudged mission={mission} verdict={verdict} />
            {!done && <Task mission={mission} />}
            <CheckList checks={checks} />
            {verdict && <CasesTried cases={verdict.cases} />}
            <Help control={control} mission={mission} done={done} />
          </>
        )}
      </div>
      <Button
        kind="plain"
        icon={folded.value ? ChevronDown : ChevronUp}
        label={folded.value ? texts.value.activity.unfold : texts.value.activity.fold}
        testId="mission-fold"
        open={!folded.value}
        onPress={() => {
          folded.value = !folded.value;
        }}
      />
    </section>
  );
}

interface MissionHeadProps {
  mission: Activity;
  done: boolean;
  /** The checks, if the card is folded and shows how many are met; else null. */
  checks: readonly CheckProgress[] | null;
}

function MissionHead({ mission, done, checks }: MissionHeadProps) {
  const Icon = done ? CircleCheck : Target;
  const met = checks?.filter(({ state }) => state === "met").length ?? 0;
  return (
    <h2 class="mission__title row middle gap-2">
      <Icon class="icon" aria-hidden="true" />
      <span>
        {mission.number} {mission.title}
      </span>
      {checks && (
        <>
          <span class="mission__count">
            {texts.value.activity.count({ met, all: checks.length })}
          </span>
          <span class="mission__brief one-line">{mission.criteria}</span>
        </>
      )}
    </h2>
  );
}

/** The story. With several cases, also the criteria: the check list only has checks that all cases share. */
function Task({ mission: { story, criteria, n_cases } }: { mission: Activity }) {
  return (
    <>
      <p>{story}</p>
      {n_cases > 1 && <p class="mission__criteria">{criteria}</p>}
    </>
  );
}

interface HelpProps {
  control: StudioControl;
  mission: Activity;
  done: boolean;
}

/** The hints, which open one after the other and stay open, and a button to the block of the verdict. */
function Help({ control, mission: { hints }, done }: HelpProps) {
  const { activity } = texts.value;
  const { open } = control;
  const n = Math.min(open.setup.value.n_hints, hints.length);
  return (
    <div class="mission__hints">
      {n > 0 && (
        <ol aria-label={activity.hints}>
          {hints.slice(0, n).map((hint) => (
            <li key={hint}>{hint}</li>
          ))}
        </ol>
      )}
      <ShowBlock control={control} />
      {n < hints.length && !done && (
        <Button
          kind="plain"
          icon={Lightbulb}
          testId="mission-hint"
          onPress={() => open.changeSetup({ n_hints: n + 1 })}
        >
          {activity.openHint({ n: n + 1, all: hints.length })}
        </Button>
      )}
    </div>
  );
}

/** Button that shows the block of the verdict, until the group changes the program. */
function ShowBlock({ control }: { control: StudioControl }) {
  if (!control.advice.value) return null;
  return (
    <Button
      kind="plain"
      icon={LocateFixed}
      testId="advice-block"
      onPress={() => control.goToAdvice()}
    >
      {texts.value.studio.goToBlock}
    </Button>
  );
}

function UnknownMission() {
  const { activity } = texts.value;
  return (
    <section class="mission row top gap-4" aria-label={activity.mission} data-testid="mission">
      <p class="mission__words">{activity.unknown}</p>
    </section>
  );
}
