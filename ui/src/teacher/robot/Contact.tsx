import { Radio } from "lucide-preact";
import { useState } from "preact/hooks";
import type { RobotContact } from "../../api/model";
import { robotsApi } from "../../api/robots";
import { language, texts } from "../../i18n";
import { decimal } from "../../i18n/format";
import { Button } from "../../kit/Button";
import { useAction } from "../../kit/requests/action";
import { FaultLine } from "../../kit/requests/FaultLine";
import { asTeacher } from "../../shell/teacher/teacher_session";

/** Tests the connection to the robot of the saved description; the robot does not move. */
export function Contact({ link }: { link: string }) {
  const { contact: labels } = texts.value.robotSetup;
  const [found, setFound] = useState<RobotContact | null>(null);
  const { busy, fault, act } = useAction(asTeacher);
  const ask = () => {
    setFound(null);
    return act(async () => setFound(await robotsApi.contact(link)));
  };
  return (
    <section class="robot-contact" aria-label={labels.title}>
      <h2>{labels.title}</h2>
      <p class="teacher__hint">{labels.hint}</p>
      <Button icon={Radio} busy={busy} testId="robot-contact" onPress={ask}>
        {labels.ask}
      </Button>
      <p role="status" class="robot-contact__found" data-testid="robot-found">
        {busy && labels.asking}
        {found && !found.problem && contactText(found)}
      </p>
      <FaultLine
        fault={found?.problem ? { message: found.problem, remedy: found.remedy ?? "" } : fault}
      />
    </section>
  );
}

function contactText({ x_m, y_m, rate_hz, battery }: RobotContact): string {
  const { contact: labels } = texts.value.robotSetup;
  const number = (value: number | null, digits: number) =>
    decimal(value ?? 0, digits, language.value);
  const there = labels.found({ x: number(x_m, 2), y: number(y_m, 2), rate: number(rate_hz, 0) });
  return battery === null
    ? there
    : `${there} ${labels.battery({ percent: number(battery * 100, 0) })}`;
}
