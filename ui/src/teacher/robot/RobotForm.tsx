import { Check, Trash2 } from "lucide-preact";
import { useState } from "preact/hooks";
import type { RealRobot } from "../../api/model";
import { robotsApi } from "../../api/robots";
import { language, texts } from "../../i18n";
import { linkWords } from "../../i18n/reasons";
import { Button } from "../../kit/Button";
import { Form } from "../../kit/Form";
import { useAct } from "../../kit/requests/act";
import { FaultLine } from "../../kit/requests/FaultLine";
import { asTeacher } from "../../shell/teacher/teacher_session";
import { useDraft } from "../useDraft";
import { Contact } from "./Contact";
import { RobotFields } from "./RobotFields";
import { RobotNow } from "./RobotNow";
import { draftOf, recordOf } from "./record";

interface RobotFormProps {
  robot: RealRobot;
  onChanged(robot: RealRobot): void;
}

/** The record of one kind of robot: speeds, room, address, and tolerances folded away. */
export function RobotForm({ robot, onChanged }: RobotFormProps) {
  const { robotSetup: say } = texts.value;
  const [isKept, setKept] = useState(false);
  const { busy, fault, act, clear } = useAct(asTeacher);
  const { draft, field, fill } = useDraft<string>(draftOf(robot, language.value), () => {
    setKept(false);
    clear();
  });
  const change = (work: () => Promise<RealRobot>) => act(async () => onChanged(await work()));
  const keep = async () =>
    setKept(await change(() => robotsApi.keep(robot.link, recordOf(robot.fields, draft))));
  return (
    <Form class="panel card" onSubmit={keep}>
      <p>{linkWords(robot.link, language.value)?.remedy}</p>
      <p class="robot-form__state" data-set-up={robot.is_set_up}>
        {robot.is_set_up ? say.isSetUp : say.notSetUp}
      </p>
      <RobotFields robot={robot} draft={draft} field={field} fill={fill} />
      <div class="teacher__row">
        <Button submit kind="main" icon={Check} busy={busy} testId="robot-keep">
          {say.keep}
        </Button>
        {robot.is_set_up && (
          <Button
            icon={Trash2}
            testId="robot-forget"
            onPress={() => change(() => robotsApi.forget(robot.link))}
          >
            {say.forget}
          </Button>
        )}
      </div>
      <p class="teacher__done" role="status">
        {isKept && say.kept}
      </p>
      <FaultLine fault={fault} />
      {robot.is_set_up && <RobotNow robot={robot} draft={draft} fill={fill} />}
      {robot.is_set_up && <Contact link={robot.link} />}
    </Form>
  );
}
