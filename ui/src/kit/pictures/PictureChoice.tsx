import { useId } from "preact/hooks";
import { texts } from "../../i18n";
import { GroupPicture } from "./GroupPicture";
import { PICTURE_NAMES, type PictureName } from "./pictures";

interface PictureChoiceProps {
  chosen: string;
  /** Pictures of other groups of the class: dimmed, but available. */
  taken: readonly string[];
  onChoose(name: PictureName): void;
}

/** Radio group of all pictures. */
export function PictureChoice({ chosen, taken, onChoose }: PictureChoiceProps) {
  const { classes } = texts.value;
  const name = useId();
  return (
    <fieldset class="pictures">
      <legend class="visually-hidden">{classes.picture}</legend>
      {PICTURE_NAMES.map((one) => {
        const isTaken = taken.includes(one);
        const words = isTaken ? classes.taken(classes.pictures[one]) : classes.pictures[one];
        return (
          <label
            key={one}
            class={`pictures__one ${isTaken ? "pictures__one--taken" : ""}`}
            title={words}
            data-testid="picture"
            data-name={one}
          >
            <input
              type="radio"
              class="visually-hidden"
              name={name}
              aria-label={words}
              checked={one === chosen}
              onClick={() => onChoose(one)}
            />
            <GroupPicture name={one} />
          </label>
        );
      })}
    </fieldset>
  );
}
