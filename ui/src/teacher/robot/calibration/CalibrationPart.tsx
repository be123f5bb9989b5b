import { useSignal } from "@preact/signals";
import { Trash2 } from "lucide-preact";
import { calibrationApi } from "../../../api/calibration";
import type { CalibratedRobot } from "../../../api/model";
import { language, texts } from "../../../i18n";
import { Button } from "../../../kit/Button";
import { Loaded } from "../../../kit/requests/Loaded";
import { UndoBanner } from "../../../kit/UndoBanner";
import { asTeacher } from "../../../shell/teacher/teacher_session";
import { dateAndTime } from "../../time_format";
import { useTeacherLoaded } from "../../useTeacherLoaded";
import { ChooseRuns } from "./ChooseRuns";
import { PatternPart } from "./PatternPart";

/** The robots of the simulator that learned from a real one, and how to make one from runs. */
export function CalibrationPart() {
  const { calibration: labels } = texts.value;
  const found = useTeacherLoaded(language.value, loadAll);
  const deleted = useSignal<CalibratedRobot | null>(null);
  const remove = async (one: CalibratedRobot) => {
    await asTeacher(() => calibrationApi.remove(one.id));
    deleted.value = one;
    await found.reload();
  };
  return (
    <section class="calibration">
      <h2>{labels.title}</h2>
      <p class="teacher__hint">{labels.hint}</p>
      <Deleted one={deleted} onBack={found.reload} />
      <Loaded of={found}>
        {({ runs, robots }) => (
          <>
            <CalibratedRobots robots={robots} onDelete={remove} />
            <PatternPart runs={runs} />
            <ChooseRuns runs={runs} onSaved={found.reload} />
          </>
        )}
      </Loaded>
    </section>
  );
}

async function loadAll() {
  const [runs, robots] = await Promise.all([calibrationApi.realRuns(), calibrationApi.robots()]);
  return { runs, robots };
}

interface CalibratedRobotsProps {
  robots: readonly CalibratedRobot[];
  onDelete(one: CalibratedRobot): Promise<void>;
}

function CalibratedRobots({ robots, onDelete }: CalibratedRobotsProps) {
  const { calibration: labels } = texts.value;
  return (
    <ul class="calibration__robots">
      {robots.map((one) => (
        <li key={one.id} class="card row middle gap-4" data-testid="calibrated-robot">
          <strong>{one.title}</strong>
          <span class="aside">{dateAndTime(one.created_at, language.value)}</span>
          <Button
            kind="plain"
            icon={Trash2}
            label={labels.deleteOf({ title: one.title })}
            testId="calibrated-delete"
            onPress={() => onDelete(one)}
          />
        </li>
      ))}
    </ul>
  );
}

interface DeletedProps {
  one: { value: CalibratedRobot | null };
  onBack(): Promise<void>;
}

function Deleted({ one, onBack }: DeletedProps) {
  const { calibration: labels } = texts.value;
  const { value: robot } = one;
  if (!robot) return null;
  return (
    <UndoBanner
      text={labels.deleted({ title: robot.title })}
      action={labels.takeBack}
      testId="calibrated-undo"
      onBack={async () => {
        await asTeacher(() => calibrationApi.restore(robot.id));
        one.value = null;
        await onBack();
      }}
      onClose={() => {
        one.value = null;
      }}
    />
  );
}
