import { texts } from "../i18n";
import { KeyHelp } from "./KeyHelp";
import type { Action } from "./keys";
import type { Picture } from "./picture";

interface PictureCoverProps {
  picture: Picture;
  /** The keys that this presentation has. */
  actions: readonly Action[];
}

/** The keys over a presentation, or a black picture. */
export function PictureCover({ picture, actions }: PictureCoverProps) {
  return (
    <>
      {picture.helps.value && <KeyHelp actions={actions} />}
      {picture.isBlack.value && (
        <div class="presentation__black" role="status" data-testid="presentation-black">
          <span class="visually-hidden">{texts.value.projector.isBlack}</span>
        </div>
      )}
    </>
  );
}
