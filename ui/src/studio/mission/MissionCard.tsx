import { ChevronDown, ChevronUp, CircleCheck, LocateFixed, Target } from "lucide-preact";
import { useEffect } from "preact/hooks";
import type { Activity } from "../../api/model";
import { language, texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { listen } from "../../kit/listen";
import { report } from "../../shell/session";
import type { StudioControl } from "../studio_control";
import { type Mark, type MissionState, missionState } from "./mission_state";
import { Sheet } from "./Sheet";

/**
 * The mission of the group: one line that stays, and a sheet over the program with picture, story, check list and hints.
 */
export function MissionCard({ control }: { control: StudioControl }) {
  const { open, missionSheet } = control;
  useEffect(() => {
    open.loadMission().catch(report); // the server sends its texts in the language of the page
  }, [open, language.value]);
  const { value: mission } = open.mission;
  if (!mission) return open.setup.value.activity ? <UnknownMission /> : null;
  const state = missionState(control, mission);
  return (
    <section
      class="mission"
      aria-label={texts.value.activity.mission}
      data-testid="mission"
      data-done={state.isDone}
    >
      <Line control={control} mission={mission} state={state} />
      {missionSheet.isOpen.value && <Sheet control={control} mission={mission} state={state} />}
      <ClosesAtEscape control={control} />
    </section>
  );
}

interface LineProps {
  control: StudioControl;
  mission: Activity;
  state: MissionState;
}

function Line({ control, mission, state: { isDone, marks } }: LineProps) {
  const { activity } = texts.value;
  const { missionSheet } = control;
  const isOpen = missionSheet.isOpen.value;
  const Icon = isDone ? CircleCheck : Target;
  const title = `${mission.number} ${mission.title}`;
  return (
    <div class="mission__line row middle gap-2">
      <Icon class="icon mission__icon" aria-hidden="true" />
      <h2 class="mission__title one-line shrinks" title={title} data-shortened>
        {title}
      </h2>
      <Marks marks={marks} />
      <span class="grows" />
      <ShowBlock control={control} />
      <Button
        kind="plain"
        icon={isOpen ? ChevronUp : ChevronDown}
        tip={isOpen ? activity.fold : activity.unfold}
        testId="mission-fold"
        open={isOpen}
        onPress={() => {
          missionSheet.isOpen.value = !isOpen;
        }}
      >
        {activity.mission}
      </Button>
    </div>
  );
}

/** A dot for each check and each further case, and how many are met. */
function Marks({ marks }: { marks: readonly Mark[] }) {
  const met = marks.filter((mark) => mark === "met").length;
  return (
    <span class="mission__marks row middle rigid" data-testid="mission-marks">
      {marks.map((mark, index) => (
        <span key={index} class="mission__mark" data-state={mark} aria-hidden="true" />
      ))}
      <span class="mission__count">{texts.value.activity.count({ met, all: marks.length })}</span>
    </span>
  );
}

/** Button that shows the block of the verdict, until the group changes the program. */
function ShowBlock({ control }: { control: StudioControl }) {
  if (!control.advice.value) return null;
  return (
    <Button
      kind="plain"
      class="mission__show rigid"
      icon={LocateFixed}
      testId="advice-block"
      onPress={() => control.goToAdvice()}
    >
      {texts.value.studio.goToBlock}
    </Button>
  );
}

function ClosesAtEscape({ control }: { control: StudioControl }) {
  useEffect(
    () =>
      listen(window, {
        keydown: ({ key }) => {
          if (key === "Escape") control.missionSheet.close();
        },
      }),
    [control],
  );
  return null;
}

function UnknownMission() {
  const { activity } = texts.value;
  return (
    <section class="mission" aria-label={activity.mission} data-testid="mission">
      <p class="mission__line mission__unknown row middle">{activity.unknown}</p>
    </section>
  );
}
