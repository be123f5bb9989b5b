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

/**
 * The fields of a robot description. What a search finds, or else the address, comes first; the rest has values that
 * do, and is folded.
 */
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
  const isSearched = draft.domain !== undefined;
  return (
    <>
      {isSearched ? (
        <FoundRobots robot={robot} draft={draft} fill={fill} />
      ) : (
        <fieldset class="robot-form__part">
          <legend>{parts.address}</legend>
          {inputs("address")}
        </fieldset>
      )}
      <details class="folded">
        <summary data-testid="robot-limits">{limitsText(draft)}</summary>
        <div class="robot-form__part">
          {inputs("speed")}
          {inputs("room")}
          <RoomPicture draft={draft} />
        </div>
      </details>
      {isSearched && (
        <details class="folded">
          <summary data-testid="robot-address">{parts.address}</summary>
          <div class="robot-form__part">{inputs("address")}</div>
        </details>
      )}
      <details class="folded">
        <summary data-testid="robot-tolerances">{parts.tolerance}</summary>
        <div class="robot-form__part">{inputs("tolerance")}</div>
      </details>
    </>
  );
}

/** The speed and the room that hold now, also while their fields are folded. */
function limitsText(draft: Draft): string {
  return texts.value.robotSetup.parts.limits({
    speed: draft.max_v_mps ?? "",
    width: draft["room.width_m"] ?? "",
    depth: draft["room.depth_m"] ?? "",
  });
}
