import { useSignal } from "@preact/signals";
import { Play, TriangleAlert } from "lucide-preact";
import { useEffect, useRef } from "preact/hooks";
import { language, texts } from "../../i18n";
import { decimal } from "../../i18n/format";
import { Button } from "../../kit/Button";
import { Form } from "../../kit/Form";
import { chosenRobot, isChecked } from "../../run/real/real_robot";
import { TEST } from "../../shell/testids";
import type { StudioControl } from "../studio_control";

/** The check list before a real robot moves for the first time; Run opens it. */
export function BeforeRun({ control }: { control: StudioControl }) {
  const { value: robot } = chosenRobot;
  const asked = control.asksBefore.value;
  const done = useSignal<readonly number[]>([]);
  const first = useRef<HTMLInputElement>(null);
  useEffect(() => {
    done.value = [];
    first.current?.focus();
  }, [asked]);
  if (!asked || !robot) return null;
  const { before } = texts.value.robot;
  const speed = (value: number) => decimal(value, 2, language.value);
  const points = [...before.points, before.speed(speed(robot.max_v_mps), speed(robot.slow_v_mps))];
  const go = () => {
    isChecked.value = true;
    control.asksBefore.value = null;
    void control.run(asked.paused);
  };
  return (
    <Form class="before-run card" testId={TEST.beforeRun} aria-label={before.title} onSubmit={go}>
      <h2 class="before-run__title">
        <TriangleAlert class="icon" aria-hidden="true" />
        {before.title}
      </h2>
      {points.map((words, index) => (
        <label key={words} class="before-run__point">
          <input
            ref={index === 0 ? first : null}
            type="checkbox"
            checked={done.value.includes(index)}
            data-testid={TEST.beforePoint}
            onChange={({ currentTarget: { checked } }) => {
              const others = done.value.filter((one) => one !== index);
              done.value = checked ? [...others, index] : others;
            }}
          />
          {words}
        </label>
      ))}
      <div class="before-run__buttons">
        <Button
          submit
          kind="main"
          icon={Play}
          testId={TEST.beforeGo}
          disabled={done.value.length < points.length}
        >
          {before.go}
        </Button>
        <Button kind="plain" onPress={() => (control.asksBefore.value = null)}>
          {before.later}
        </Button>
      </div>
    </Form>
  );
}
