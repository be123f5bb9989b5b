import type { RealRobot, RobotField } from "../../api/model";
import { texts } from "../../i18n";
import { Field } from "../../kit/Field";
import { FoundRobots } from "./FoundRobots";
import { RoomPicture } from "./RoomPicture";
import type { Draft } from "./robot_description";

interface RobotFieldsProps {
  robot: RealRobot;
  draft: Draft;
  field(name: string): { value: string | undefined; onText(text: string): void };
  fill(texts: Draft): void;
}

/** The fields of a robot description, in sections. */
export function RobotFields({ robot, draft, field, fill }: RobotFieldsProps) {
  const { parts } = texts.value.robotSetup;
  const inputs = (part: RobotField["part"]) =>
    robot.fields
      .filter((one) => one.part === part)
      .map(({ name, label, hint, low }) => (
        <Field
          key={name}
          label={label}
          hint={hint}
          maxLength={100}
          inputMode={low === null ? "text" : "decimal"}
          data-testid="robot-field"
          data-name={name}
          value={field(name).value ?? ""}
          onText={field(name).onText}
        />
      ));
  return (
    <>
      <fieldset class="robot-form__part">
        <legend>{parts.speed}</legend>
        {inputs("speed")}
      </fieldset>
      <fieldset class="robot-form__part">
        <legend>{parts.room}</legend>
        {inputs("room")}
        <RoomPicture draft={draft} />
      </fieldset>
      <fieldset class="robot-form__part">
        <legend>{parts.address}</legend>
        {inputs("address")}
        {draft.domain !== undefined && <FoundRobots robot={robot} draft={draft} fill={fill} />}
      </fieldset>
      <details class="robot-form__more">
        <summary>{parts.tolerance}</summary>
        <div class="robot-form__part">{inputs("tolerance")}</div>
      </details>
    </>
  );
}
