import { Check, Hand } from "lucide-preact";
import { useEffect, useRef } from "preact/hooks";
import type { TextKey } from "../../blocks/texts";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { useInstance } from "../../kit/instance";
import { beginActivity } from "../../shell/begin_activity";
import type { StudioControl } from "../studio_control";
import type { Progress, TourStep } from "./steps";
import { useTargets } from "./targets";
import { Tour } from "./tour";

/** The activity with which the tour ends. */
const FIRST_MISSION = "to_the_bakery";

/**
 * The guided first drive: a balloon beside a ring. It takes the focus from no other element and
 * covers nothing that a step needs.
 */
export function TourBalloon({ control }: { control: StudioControl }) {
  const tour = useInstance(() => new Tour(control));
  const balloon = useRef<HTMLElement>(null);
  const { progress } = tour;
  const { step } = progress.value;
  const { rings, corner, drag } = useTargets(step, control, balloon);
  useFocus(balloon, step);
  const labels = texts.value.help.tour;
  if (tour.inMission && control.missionSheet.isOpen.value) return null; // the sheet is read first
  return (
    <>
      {rings.map(({ x, y, width, height }, index) => (
        <div
          key={index}
          class="tour__ring"
          data-testid="tour-ring"
          style={{ left: x, top: y, width, height }}
        />
      ))}
      {drag && (
        <Hand
          class="tour__hand"
          aria-hidden="true"
          style={{
            left: drag.x,
            top: drag.y,
            "--right": `${drag.right}px`,
            "--down": `${drag.down}px`,
          }}
        />
      )}
      <section
        ref={balloon}
        class="tour card grid gap-2"
        aria-label={labels.title}
        tabIndex={-1}
        data-testid="tour"
        data-step={step}
        style={{ left: corner.x, top: corner.y }}
        onKeyDown={({ key }) => key === "Escape" && tour.end()}
      >
        <Ticks step={step} steps={tour.steps} />
        <p class="tour__words" role="status">
          {stepText(progress.value, tour.inMission)}
        </p>
        <Buttons tour={tour} step={step} control={control} />
      </section>
    </>
  );
}

/** Focuses the balloon at each step, for keyboard users, unless another element has the focus. */
function useFocus(balloon: { readonly current: HTMLElement | null }, step: TourStep): void {
  useEffect(() => {
    if (document.activeElement !== document.body) return;
    const { current: element } = balloon;
    (step === "hello" ? element?.querySelector("button") : element)?.focus();
  }, [step]);
}

function stepText({ step, isOther }: Progress, inMission: boolean): string {
  const { tour } = texts.value.help;
  const { run } = texts.value.run;
  switch (step) {
    case "hello":
      return tour.hello;
    case "move":
      return tour.move({ block: blockName("MOVE_FORWARD"), start: blockName("PROGRAM_START") });
    case "run":
      return isOther ? tour.other : tour.run({ run });
    case "watch":
      return isOther ? tour.watchOther : tour.watch;
    case "turn":
      return tour.turn({ block: blockName("TURN") });
    case "again":
      return isOther ? tour.other : tour.again;
    case "end":
      return (inMission ? tour.endMission : tour.end)({ stop: texts.value.run.stop });
  }
}

/** The name of a block: its text up to its first value. */
function blockName(key: TextKey): string {
  return texts.value.blocks[key].replace(/^%1 /, "").replace(/ ?%.*/, "");
}

function Ticks({ step, steps }: { step: TourStep; steps: readonly TourStep[] }) {
  const now = steps.indexOf(step);
  return (
    <p class="row gap-1">
      <span class="visually-hidden">
        {texts.value.help.tour.place({ n: now + 1, all: steps.length })}
      </span>
      {steps.map((one, index) => (
        <span key={one} class="tour__tick" data-now={index === now} aria-hidden="true">
          {index < now && <Check class="icon" />}
        </span>
      ))}
    </p>
  );
}

function Buttons({ tour, step, control }: { tour: Tour; step: TourStep; control: StudioControl }) {
  const labels = texts.value.help.tour;
  const group = control.open.program.group_id;
  if (step === "end" && tour.inMission) {
    return (
      <div class="row">
        <Button kind="main" testId="tour-free" onPress={() => tour.end()}>
          {labels.toMission}
        </Button>
      </div>
    );
  }
  if (step === "end") {
    return (
      <div class="row wrap gap-2">
        <Button
          kind="main"
          testId="tour-mission"
          onPress={() => beginActivity(group, FIRST_MISSION)}
        >
          {labels.mission}
        </Button>
        <Button testId="tour-free" onPress={() => tour.end()}>
          {labels.free}
        </Button>
      </div>
    );
  }
  return (
    <div class="row wrap gap-2">
      {step === "hello" && (
        <Button kind="main" testId="tour-go" onPress={() => tour.next()}>
          {labels.go}
        </Button>
      )}
      {tour.canShow.value && step !== "watch" && step !== "hello" && (
        <Button testId="tour-show" onPress={() => tour.show()}>
          {labels.show}
        </Button>
      )}
      <Button testId="tour-skip" onPress={() => tour.end()}>
        {labels.skip}
      </Button>
    </div>
  );
}
