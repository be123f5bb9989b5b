import type { Group } from "../../api/model";
import { texts } from "../../i18n";
import { PopupButton } from "../../kit/pictures/PopupButton";
import { liveryOf } from "../../scene/livery/livery";
import { RobotPicture } from "../../scene/livery/RobotPicture";
import type { Appearance } from "./appearance";
import { RobotFields } from "./RobotFields";

interface RobotButtonProps {
  appearance: Appearance;
  groupName: string;
  /** The other groups of the class. */
  others: readonly Group[];
  onChange(changes: Partial<Appearance>): void;
}

/** Shows the robot of a new group; a press opens the choice of colour, pattern and name below. */
export function RobotButton({ appearance, groupName, others, onChange }: RobotButtonProps) {
  const { livery } = texts.value;
  return (
    <PopupButton
      label={livery.open}
      testId="choose-robot"
      class="robot-button"
      face={
        <>
          <RobotPicture livery={liveryOf({ ...appearance, name: groupName })} />
          <span>{livery.title}</span>
        </>
      }
    >
      {() => (
        <RobotFields
          appearance={appearance}
          groupName={groupName}
          usedColors={others.map((one) => one.color)}
          onChange={onChange}
        />
      )}
    </PopupButton>
  );
}
