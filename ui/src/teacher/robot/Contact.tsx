import { Radio } from "lucide-preact";
import { useState } from "preact/hooks";
import type { RobotContact } from "../../api/model";
import { robotsApi } from "../../api/robots";
import { language, texts } from "../../i18n";
import { decimal } from "../../i18n/format";
import { Button } from "../../kit/Button";
import { useAct } from "../../kit/requests/act";
import { FaultLine } from "../../kit/requests/FaultLine";
import { asTeacher } from "../../shell/teacher/teacher_session";

/** Tries whether the robot, as it is saved, can be reached; it does not move. */
export function Contact({ link }: { link: string }) {
  const { contact: say } = texts.value.robotSetup;
  const [found, setFound] = useState<RobotContact | null>(null);
  const { busy, fault, act } = useAct(asTeacher);
  const ask = () => {
    setFound(null);
    return act(async () => setFound(await robotsApi.contact(link)));
  };
  return (
    <section class="robot-contact" aria-label={say.title}>
      <h2>{say.title}</h2>
      <p class="teacher__hint">{say.hint}</p>
      <Button icon={Radio} busy={busy} testId="robot-contact" onPress={ask}>
        {say.ask}
      </Button>
      <p role="status" class="robot-contact__found" data-testid="robot-found">
        {busy && say.asking}
        {found && !found.problem && wordsOf(found)}
      </p>
      <FaultLine
        fault={found?.problem ? { message: found.problem, remedy: found.remedy ?? "" } : fault}
      />
    </section>
  );
}

function wordsOf({ x_m, y_m, rate_hz, battery }: RobotContact): string {
  const { contact: say } = texts.value.robotSetup;
  const number = (value: number | null, digits: number) =>
    decimal(value ?? 0, digits, language.value);
  const there = say.found(number(x_m, 2), number(y_m, 2), number(rate_hz, 0));
  return battery === null ? there : `${there} ${say.battery(number(battery * 100, 0))}`;
}
