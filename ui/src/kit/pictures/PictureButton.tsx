import { ChevronDown } from "lucide-preact";
import type { RefObject } from "preact";
import { useLayoutEffect, useRef, useState } from "preact/hooks";
import { texts } from "../../i18n";
import { Button } from "../Button";
import { GroupPicture } from "./GroupPicture";
import { PictureChoice } from "./PictureChoice";
import { isPicture, type PictureName } from "./pictures";

interface PictureButtonProps {
  chosen: string;
  used: readonly string[];
  onChoose(name: PictureName): void;
}

/**
 * Shows the chosen picture; a press opens all pictures below. Escape or a press elsewhere closes
 * them.
 */
export function PictureButton(props: PictureButtonProps) {
  const { classes } = texts.value;
  const place = useRef<HTMLDivElement>(null);
  const [open, setOpen] = useState(false);
  const close = (withFocus: boolean) => {
    setOpen(false);
    if (withFocus) place.current?.querySelector("button")?.focus();
  };
  const byHand = usePopup(place, open, close);
  const choose = (name: PictureName) => {
    props.onChoose(name);
    if (byHand.current) close(true);
  };
  const now = isPicture(props.chosen) ? classes.pictures[props.chosen] : classes.noPicture;
  return (
    <div class="picture-button" ref={place}>
      <Button
        kind="bare"
        class="picture-button__button"
        open={open}
        label={classes.choosePicture({ now })}
        tip={classes.choosePicture({ now })}
        testId="choose-picture"
        onPress={() => setOpen(!open)}
      >
        <GroupPicture name={props.chosen} />
        <ChevronDown class="icon picture-button__more" aria-hidden="true" />
      </Button>
      {open && (
        <div class="picture-button__all card">
          <PictureChoice {...props} onChoose={choose} />
        </div>
      )}
    </div>
  );
}

/**
 * Closes a popup on a press outside, on loss of focus, on Enter and on Escape. The returned ref
 * holds whether the last input was the pointer: a press chooses and closes, an arrow key only
 * chooses.
 */
function usePopup(
  place: RefObject<HTMLElement>,
  open: boolean,
  close: (withFocus: boolean) => void,
): { readonly current: boolean } {
  const byHand = useRef(false);
  useLayoutEffect(() => {
    const inside = place.current;
    if (!open || !inside) return;
    inside.querySelector<HTMLInputElement>("input:checked")?.focus();
    const leave = ({ target, type }: Event) => {
      if (type === "pointerdown") byHand.current = true;
      if (!inside.contains(target as Node)) close(false);
    };
    const end = (event: KeyboardEvent) => {
      byHand.current = false;
      if (event.key !== "Escape" && event.key !== "Enter") return;
      event.preventDefault();
      close(true);
    };
    const ended = new AbortController();
    const { signal } = ended;
    document.addEventListener("pointerdown", leave, { signal });
    document.addEventListener("focusin", leave, { signal });
    inside.addEventListener("keydown", end, { signal });
    return () => ended.abort();
  }, [open]);
  return byHand;
}
