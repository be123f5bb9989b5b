import { useId } from "preact/hooks";
import { texts } from "../../i18n";
import { GroupPicture } from "./GroupPicture";
import { PICTURE_NAMES, type PictureName } from "./pictures";

interface PictureChoiceProps {
  chosen: string;
  /** Pictures of other groups of the class: dimmed, but available. */
  used: readonly string[];
  onChoose(name: PictureName): void;
}

/** Radio group of all pictures. */
export function PictureChoice({ chosen, used, onChoose }: PictureChoiceProps) {
  const { classes } = texts.value;
  const name = useId();
  return (
    <fieldset class="pictures">
      <legend class="visually-hidden">{classes.picture}</legend>
      {PICTURE_NAMES.map((one) => {
        const isUsed = used.includes(one);
        const label = isUsed
          ? classes.taken({ picture: classes.pictures[one] })
          : classes.pictures[one];
        return (
          <label
            key={one}
            class={`pictures__one ${isUsed ? "pictures__one--taken" : ""}`}
            title={label}
            data-testid="picture"
            data-name={one}
          >
            <input
              type="radio"
              class="visually-hidden"
              name={name}
              aria-label={label}
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
