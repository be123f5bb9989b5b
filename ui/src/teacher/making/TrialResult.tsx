import { CircleCheck, TriangleAlert } from "lucide-preact";
import type { Trial, Trials } from "../../api/model";
import { texts } from "../../i18n";
import { FaultLine } from "../../kit/requests/FaultLine";

/** Result of the trial: the solution must pass and a program without commands must fail, on both robots. */
export function TrialResult({ trials: { faults, trials } }: { trials: Trials }) {
  const { trial: labels } = texts.value.making;
  const isRight = faults.length === 0 && trials.every((one) => one.is_right);
  return (
    <div role="status" data-testid="making-trials" data-right={isRight}>
      {faults.map((fault) => (
        <FaultLine key={fault.pointer} fault={fault} />
      ))}
      <ul class="making__trials">
        {trials.map((one) => (
          <TrialRow key={`${one.program} ${one.preset}`} trial={one} />
        ))}
      </ul>
      {faults.length === 0 && <p>{isRight ? labels.right : labels[whatIsWrong(trials)]}</p>}
    </div>
  );
}

/** The text for trials of which not all are right. */
function whatIsWrong(trials: readonly Trial[]): "onlyIdeal" | "emptyPasses" | "wrong" {
  const wrong = trials.filter((one) => !one.is_right);
  if (wrong.every(({ program }) => program !== "solution")) return "emptyPasses";
  return wrong.every(({ preset }) => preset !== "ideal") ? "onlyIdeal" : "wrong";
}

function TrialRow({ trial }: { trial: Trial }) {
  const { trial: labels } = texts.value.making;
  const { program, preset, passed, is_right, words } = trial;
  const Icon = is_right ? CircleCheck : TriangleAlert;
  const who = program === "solution" ? labels.solution : labels.empty;
  const robot = preset === "ideal" ? labels.ideal : labels.realistic;
  return (
    <li class={`row top gap-2 making__trial--${is_right ? "right" : "wrong"}`}>
      <Icon class="icon" aria-hidden="true" />
      <span>
        <strong>
          {who}, {robot}: {passed ? labels.passes : labels.fails}
        </strong>{" "}
        {program === "solution" && words}
      </span>
    </li>
  );
}
