import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import type { GoalPicture as Goal } from "../../api/model";
import { texts } from "../../i18n";
import { labelled } from "../../i18n/phrases";
import { Button } from "../../kit/Button";
import { listen } from "../../kit/listen";
import { lazy } from "../../shell/lazy";

const GoalPicture = lazy(async () => (await import("../../scene/small/GoalPicture")).GoalPicture);

interface LessonGoalProps {
  activity: string;
  goal: Goal;
}

/** The goal of the lesson's activity as a small picture in the header; a press shows it large. */
export function LessonGoal({ activity, goal }: LessonGoalProps) {
  const { goal: label, showGoal } = texts.value.activity;
  const open = useSignal(false);
  const place = useRef<HTMLDivElement>(null);
  const close = () => {
    open.value = false;
  };
  useEffect(() => {
    if (!open.value) return;
    return listen(window, {
      keydown: ({ key }) => key === "Escape" && close(),
      pointerdown: ({ target }) => !place.current?.contains(target as Node) && close(),
    });
  }, [open.value]);
  return (
    <div class="lesson-goal-chip" ref={place}>
      <Button
        kind="bare"
        class="lesson-goal-chip__button"
        label={labelled(showGoal, activity)}
        open={open.value}
        testId="show-goal"
        onPress={() => {
          open.value = !open.value;
        }}
      >
        <GoalPicture goal={goal} />
      </Button>
      {open.value && (
        <figure class="lesson-goal-chip__large card column gap-2" data-testid="lesson-goal">
          <GoalPicture goal={goal} label={label} />
          <figcaption>{activity}</figcaption>
        </figure>
      )}
    </div>
  );
}
