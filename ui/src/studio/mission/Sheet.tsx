import { Lightbulb, Play } from "lucide-preact";
import type { Activity } from "../../api/model";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { GoalPicture } from "../../scene/small/GoalPicture";
import { tourFor } from "../../shell/help";
import type { StudioControl } from "../studio_control";
import { isTourDue } from "../tour/due";
import { CasesTried } from "./CasesTried";
import { CheckList } from "./CheckList";
import { HowJudged } from "./HowJudged";
import type { MissionState } from "./mission_state";
import { Success } from "./Success";

interface SheetProps {
  control: StudioControl;
  mission: Activity;
  state: MissionState;
}

/** The whole mission, over the program: goal, story or success, check list, hints. */
export function Sheet({ control, mission, state }: SheetProps) {
  const { verdict, checks, isSuccess } = state;
  const passedRun = verdict?.passed ? verdict.run : null;
  return (
    <div class="mission__sheet card column gap-2" data-testid="mission-sheet" data-scrolls>
      <div class="row top gap-4">
        <GoalPicture goal={mission.goal_picture} />
        <div class="mission__words">
          {isSuccess && <Success open={control.open} mission={mission} run={passedRun} />}
          <HowJudged mission={mission} verdict={verdict} />
          {!isSuccess && <Task mission={mission} />}
          <CheckList checks={checks} />
          {verdict && <CasesTried cases={verdict.cases} ghost={control.ghost} />}
        </div>
      </div>
      <Foot control={control} mission={mission} isSuccess={isSuccess} />
    </div>
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

interface FootProps {
  control: StudioControl;
  mission: Activity;
  isSuccess: boolean;
}

/** The hints, which open one after the other and stay open until success, and the button that closes the sheet and begins a tour that is due. */
function Foot({ control, mission: { hints }, isSuccess }: FootProps) {
  const { activity } = texts.value;
  const { open } = control;
  const begin = () => {
    control.missionSheet.close();
    if (isTourDue(open)) tourFor.value = open.id;
  };
  const n = isSuccess ? 0 : Math.min(open.setup.value.n_hints, hints.length);
  return (
    <>
      {n > 0 && (
        <ol class="mission__hints" aria-label={activity.hints}>
          {hints.slice(0, n).map((hint) => (
            <li key={hint}>{hint}</li>
          ))}
        </ol>
      )}
      <div class="row middle wrap gap-2">
        <Button
          kind={isSuccess ? "plain" : "main"}
          icon={Play}
          testId="mission-start"
          data-tour={isTourDue(open)}
          onPress={begin}
        >
          {control.open.isEmpty ? activity.start : activity.toBlocks}
        </Button>
        {n < hints.length && !isSuccess && (
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
    </>
  );
}
