import { RotateCcw, RotateCw } from "lucide-preact";
import { texts } from "../i18n";
import { Button } from "../kit/Button";
import { NumberField } from "../kit/NumberField";
import { extentOf, hullPath } from "../scene/hull";
import { robotOf } from "../shell/session";
import { turned } from "./tape";

interface HeadingChoiceProps {
  headingDeg: number;
  model: string | null;
  onTurn(headingDeg: number): void;
  onType(headingDeg: number): void;
}

/** How the robot points: a drawing of it that turns in steps, and a number. */
export function HeadingChoice({ headingDeg, model, onTurn, onType }: HeadingChoiceProps) {
  const { truth } = texts.value;
  return (
    <fieldset class="tape__heading">
      <legend class="labelled__label">{truth.heading}</legend>
      <div class="row wrap middle gap-2">
        <Button
          icon={RotateCcw}
          label={truth.turnLeft}
          testId="turn-left"
          onPress={() => onTurn(turned(1, headingDeg))}
        />
        <Dial headingDeg={headingDeg} model={model} />
        <Button
          icon={RotateCw}
          label={truth.turnRight}
          testId="turn-right"
          onPress={() => onTurn(turned(-1, headingDeg))}
        />
        <NumberField
          label={truth.headingNumber}
          value={Math.round(headingDeg)}
          min={-180}
          max={180}
          step={1}
          testId="heading"
          onNumber={onType}
        />
      </div>
    </fieldset>
  );
}

/** The robot from above; ahead of the start mark is up. */
function Dial({ headingDeg, model }: Pick<HeadingChoiceProps, "headingDeg" | "model">) {
  const robot = robotOf(model);
  if (!robot) return null;
  const { length, width, back } = extentOf(robot);
  return (
    <svg class="tape__dial" viewBox="-40 -40 80 80" aria-hidden="true">
      <circle class="tape__ring" r="38" />
      <path class="truth-picture__ahead" d="M0 -26v-10m-4 4 4-4 4 4" />
      <g
        class="truth-picture__robot truth-picture__robot--measured"
        transform={`rotate(${-90 - headingDeg}) scale(${44 / length})`}
      >
        <path style={{ strokeWidth: length / 22 }} d={hullPath(robot)} />
        <path
          class="truth-picture__nose"
          transform={`translate(${back} 0) scale(${length} ${width})`}
          d="M.69 0 .35.26.42 0 .35-.26z"
        />
      </g>
    </svg>
  );
}
