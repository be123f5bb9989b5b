import { type Signal, useSignal } from "@preact/signals";
import { Play, TriangleAlert } from "lucide-preact";
import { useEffect, useRef } from "preact/hooks";
import { language, texts } from "../../i18n";
import { decimal } from "../../i18n/format";
import { Button } from "../../kit/Button";
import { Form } from "../../kit/Form";
import { chosenRobot, isChecked } from "../../run/real/real_robot";
import type { StudioControl } from "../studio_control";

/** The check list before a real robot moves for the first time. Run opens it over the blocks, not the floor. */
export function BeforeRun({ control }: { control: StudioControl }) {
  const link = chosenRobot.value?.link;
  const asked = control.asksBefore.value;
  // for another robot, Run opens the check list again
  useEffect(() => () => close(control), [link]);
  return asked && link ? <CheckList control={control} paused={asked.paused} /> : null;
}

function close(control: StudioControl): void {
  control.asksBefore.value = null;
}

interface CheckListProps {
  control: StudioControl;
  paused: boolean;
}

function CheckList({ control, paused }: CheckListProps) {
  const done = useSignal<readonly number[]>([]);
  const { before } = texts.value.robot;
  const points = [...before.points, speedText()];
  const list = useFocusInside();
  const go = () => {
    isChecked.value = true;
    close(control);
    void control.run(paused);
  };
  return (
    <Form
      class="before-run card column gap-1"
      testId="before-run"
      aria-label={before.title}
      onSubmit={go}
      onKeyDown={({ key }) => key === "Escape" && close(control)}
    >
      <h2 class="before-run__title row middle gap-2">
        <TriangleAlert class="icon" aria-hidden="true" />
        {before.title}
      </h2>
      <div ref={list}>
        {points.map((text, index) => (
          <Point key={text} text={text} index={index} done={done} />
        ))}
      </div>
      <div class="before-run__buttons row wrap gap-2">
        <Button
          submit
          kind="main"
          icon={Play}
          testId="before-go"
          disabled={done.value.length < points.length}
        >
          {before.go}
        </Button>
        <Button kind="plain" onPress={() => close(control)}>
          {before.later}
        </Button>
      </div>
    </Form>
  );
}

interface PointProps {
  text: string;
  index: number;
  /** Indices of the points that were checked off: they stay when the language changes. */
  done: Signal<readonly number[]>;
}

function Point({ text, index, done }: PointProps) {
  return (
    <label class="before-run__point row middle gap-3">
      <input
        type="checkbox"
        checked={done.value.includes(index)}
        data-testid="before-point"
        onChange={({ currentTarget: { checked } }) => {
          const others = done.value.filter((one) => one !== index);
          done.value = checked ? [...others, index] : others;
        }}
      />
      {text}
    </label>
  );
}

function speedText(): string {
  const { max_v_mps = 0, slow_v_mps = 0 } = chosenRobot.value ?? {};
  const speed = (value: number) => decimal(value, 2, language.value);
  return texts.value.robot.before.speed({ full: speed(max_v_mps), slow: speed(slow_v_mps) });
}

/** Focuses the first field of the element; at unmount, focuses the previous element again. */
function useFocusInside() {
  const inside = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const before = document.activeElement;
    inside.current?.querySelector("input")?.focus();
    return () => before instanceof HTMLElement && before.focus();
  }, []);
  return inside;
}
