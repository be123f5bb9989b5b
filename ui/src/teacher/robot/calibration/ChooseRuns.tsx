import { useSignal } from "@preact/signals";
import { Gauge, Play } from "lucide-preact";
import { calibrationApi } from "../../../api/calibration";
import type { Calibration, RealRun } from "../../../api/model";
import { language, texts } from "../../../i18n";
import { duration } from "../../../i18n/format";
import { Button } from "../../../kit/Button";
import { LinkButton } from "../../../kit/LinkButton";
import { useAction } from "../../../kit/requests/action";
import { FaultLine } from "../../../kit/requests/FaultLine";
import { robotLabel } from "../../../run/real/RobotName";
import { hashOf } from "../../../shell/route";
import { asTeacher } from "../../../shell/teacher/teacher_session";
import { dateAndTime } from "../../time_format";
import { CalibrationResult } from "./CalibrationResult";

interface ChooseRunsProps {
  runs: readonly RealRun[];
  onSaved(): Promise<void>;
}

/** Chooses runs on the real robot, and shows what they tell about it. */
export function ChooseRuns({ runs, onSaved }: ChooseRunsProps) {
  const { calibration: labels } = texts.value;
  const chosen = useSignal<readonly string[]>([]);
  const result = useSignal<Calibration | null>(null);
  const { busy, fault, act } = useAction(asTeacher);
  if (runs.length === 0) return <p class="teacher__hint">{labels.noRuns}</p>;
  const calibrate = () =>
    act(async () => {
      result.value = await calibrationApi.calibrate([...chosen.value]);
    });
  return (
    <>
      <fieldset class="calibration__runs">
        <legend>{labels.choose}</legend>
        <div class="calibration__list" data-scrolls>
          {runs.map((run) => (
            <RunChoice
              key={run.id}
              run={run}
              isChosen={chosen.value.includes(run.id)}
              onChoose={(isChosen) => {
                const others = chosen.value.filter((id) => id !== run.id);
                chosen.value = isChosen ? [...others, run.id] : others;
                result.value = null;
              }}
            />
          ))}
        </div>
      </fieldset>
      <Button
        kind="main"
        icon={Gauge}
        busy={busy}
        disabled={chosen.value.length === 0}
        testId="calibrate"
        onPress={calibrate}
      >
        {labels.calibrate}
      </Button>
      <FaultLine fault={fault} />
      {result.value && <CalibrationResult of={result.value} onSaved={onSaved} />}
    </>
  );
}

interface RunChoiceProps {
  run: RealRun;
  isChosen: boolean;
  onChoose(isChosen: boolean): void;
}

function RunChoice({ run, isChosen, onChoose }: RunChoiceProps) {
  const { calibration: labels, work } = texts.value;
  const facts = [
    run.group_name,
    robotLabel(run.link),
    dateAndTime(run.started_at, language.value),
    run.duration_s !== null && duration(run.duration_s, language.value),
  ];
  const sources = run.sources.map((one) => labels.sources[one]).join(", ");
  return (
    <div class="calibration__run row middle gap-2" data-testid="real-run" data-run={run.id}>
      <label class="row middle gap-2">
        <input
          type="checkbox"
          checked={isChosen}
          onChange={({ currentTarget }) => onChoose(currentTarget.checked)}
        />
        <span class="column">
          <strong>{run.program_name ?? work.noName}</strong>
          <span class="aside">{facts.filter(Boolean).join(" · ")}</span>
        </span>
      </label>
      <span class={sources ? "calibration__measured" : "aside"}>
        {sources ? labels.measured({ sources }) : labels.unmeasured}
      </span>
      <LinkButton icon={Play} href={hashOf({ screen: "replay", run: run.id })}>
        {labels.openRun}
      </LinkButton>
    </div>
  );
}
