import { useSignal } from "@preact/signals";
import { ArrowRight, ChevronDown, ChevronUp, CircleCheck, Lightbulb, Target } from "lucide-preact";
import { useEffect } from "preact/hooks";
import type { Activity } from "../../api/model";
import { language, texts } from "../../i18n";
import { Button } from "../../kit/Button";
import * as robot from "../../run/live";
import { GoalPicture } from "../../scene/goal/GoalPicture";
import { beginActivity } from "../../shell/begin_activity";
import { judged, report } from "../../shell/session";
import { TEST } from "../../shell/testids";
import type { OpenProgram } from "../program/open_program";

/** What the group is to solve: picture of the goal, story, criteria, hints. Folds to one line. */
export function MissionCard({ open }: { open: OpenProgram }) {
  const folded = useSignal(false);
  useEffect(() => {
    open.loadMission().catch(report); // its texts are in the language of the page
  }, [open, language.value]);
  const { value: mission } = open.mission;
  const { value: setup } = open.setup;
  if (!mission) return setup.activity ? <UnknownMission /> : null;
  const done = judged.value?.passed === true && judged.value.run === robot.live.value.run;
  return (
    <section
      class="mission"
      aria-label={texts.value.activity.mission}
      data-testid={TEST.mission}
      data-done={done}
    >
      {!folded.value && <GoalPicture goal={mission.goal_picture} />}
      <div class="mission__words">
        <MissionHead mission={mission} done={done} folded={folded.value} />
        {!folded.value && (
          <>
            <p>{mission.story}</p>
            <p class="mission__criteria">{mission.criteria}</p>
            <Hints open={open} mission={mission} done={done} />
          </>
        )}
      </div>
      {done && <Success open={open} mission={mission} />}
      <Button
        kind="plain"
        icon={folded.value ? ChevronDown : ChevronUp}
        label={folded.value ? texts.value.activity.unfold : texts.value.activity.fold}
        testId={TEST.missionFold}
        open={!folded.value}
        onPress={() => {
          folded.value = !folded.value;
        }}
      />
    </section>
  );
}

function MissionHead(props: { mission: Activity; done: boolean; folded: boolean }) {
  const { mission, done, folded } = props;
  const Icon = done ? CircleCheck : Target;
  return (
    <h2 class="mission__title">
      <Icon class="icon" aria-hidden="true" />
      <span>
        {mission.number} {mission.title}
      </span>
      {folded && <span class="mission__brief">{mission.criteria}</span>}
    </h2>
  );
}

interface HintsProps {
  open: OpenProgram;
  mission: Activity;
  done: boolean;
}

/** Hints are opened one after the other; the program remembers how many were. */
function Hints({ open, mission: { hints }, done }: HintsProps) {
  const { activity } = texts.value;
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
      {n < hints.length && !done && (
        <Button
          kind="plain"
          icon={Lightbulb}
          testId={TEST.missionHint}
          onPress={() => open.changeSetup({ n_hints: n + 1 })}
        >
          {activity.openHint(n + 1, hints.length)}
        </Button>
      )}
    </div>
  );
}

function Success({ open, mission }: { open: OpenProgram; mission: Activity }) {
  const { activity } = texts.value;
  const { next } = mission;
  return (
    <div class="mission__success" role="status" data-testid={TEST.missionDone}>
      <strong>{activity.done}</strong>
      {mission.question && <p>{mission.question}</p>}
      {next && (
        <Button
          kind="main"
          iconEnd={ArrowRight}
          testId={TEST.missionNext}
          onPress={() => beginActivity(open.program.group_id, next.name)}
        >
          {activity.next(next.title)}
        </Button>
      )}
    </div>
  );
}

function UnknownMission() {
  const { activity } = texts.value;
  return (
    <section class="mission" aria-label={activity.mission} data-testid={TEST.mission}>
      <p class="mission__words">{activity.unknown}</p>
    </section>
  );
}
