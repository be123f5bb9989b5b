import { texts } from "../../i18n";
import { GroupPicture } from "./GroupPicture";
import { PictureChoice } from "./PictureChoice";
import { PopupButton } from "./PopupButton";
import { isPicture, type PictureName } from "./pictures";

interface PictureButtonProps {
  chosen: string;
  used: readonly string[];
  onChoose(name: PictureName): void;
}

/** Shows the chosen picture; a press opens all pictures below. */
export function PictureButton(props: PictureButtonProps) {
  const { classes } = texts.value;
  const now = isPicture(props.chosen) ? classes.pictures[props.chosen] : classes.noPicture;
  return (
    <PopupButton
      label={classes.choosePicture({ now })}
      testId="choose-picture"
      face={<GroupPicture name={props.chosen} />}
    >
      {(pressed) => (
        <PictureChoice
          {...props}
          onChoose={(name) => {
            props.onChoose(name);
            pressed();
          }}
        />
      )}
    </PopupButton>
  );
}
