import { Check, Trash2 } from "lucide-preact";
import { useState } from "preact/hooks";
import type { RealRobot } from "../../api/model";
import { robotsApi } from "../../api/robots";
import { language, texts } from "../../i18n";
import { linkText } from "../../i18n/reasons";
import { Button } from "../../kit/Button";
import { Form } from "../../kit/Form";
import { useAction } from "../../kit/requests/action";
import { FaultLine } from "../../kit/requests/FaultLine";
import { asTeacher } from "../../shell/teacher/teacher_session";
import { useDraft } from "../useDraft";
import { Contact } from "./Contact";
import { RobotFields } from "./RobotFields";
import { RobotNow } from "./RobotNow";
import { descriptionOf, draftOf } from "./robot_description";

interface RobotFormProps {
  robot: RealRobot;
  onChanged(robot: RealRobot): void;
}

/** Form for the description of a kind of robot: speeds, room, address, and folded tolerances. */
export function RobotForm({ robot, onChanged }: RobotFormProps) {
  const { robotSetup: labels } = texts.value;
  const [isSaved, setSaved] = useState(false);
  const { busy, fault, act, clear } = useAction(asTeacher);
  const { draft, field, fill } = useDraft<string>(draftOf(robot, language.value), () => {
    setSaved(false);
    clear();
  });
  const change = (work: () => Promise<RealRobot>) => act(async () => onChanged(await work()));
  const save = async () =>
    setSaved(await change(() => robotsApi.save(robot.link, descriptionOf(robot.fields, draft))));
  return (
    <Form class="panel card" onSubmit={save}>
      <p>{linkText(robot.link, language.value)?.remedy}</p>
      <p class="robot-form__state" data-set-up={robot.is_set_up}>
        {robot.is_set_up ? labels.isSetUp : labels.notSetUp}
      </p>
      <RobotFields robot={robot} draft={draft} field={field} fill={fill} />
      <div class="teacher__row">
        <Button submit kind="main" icon={Check} busy={busy} testId="robot-keep">
          {labels.keep}
        </Button>
        {robot.is_set_up && (
          <Button
            icon={Trash2}
            testId="robot-forget"
            onPress={() => change(() => robotsApi.forget(robot.link))}
          >
            {labels.forget}
          </Button>
        )}
      </div>
      <p class="teacher__done" role="status">
        {isSaved && labels.kept}
      </p>
      <FaultLine fault={fault} />
      {robot.is_set_up && <RobotNow robot={robot} draft={draft} fill={fill} />}
      {robot.is_set_up && <Contact link={robot.link} />}
    </Form>
  );
}
