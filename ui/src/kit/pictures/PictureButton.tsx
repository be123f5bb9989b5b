import { ChevronDown } from "lucide-preact";
import { useLayoutEffect, useRef, useState } from "preact/hooks";
import { TEST } from "../app/testids";
import { texts } from "../i18n";
import { GroupPicture } from "./GroupPicture";
import { PictureChoice } from "./PictureChoice";
import { isPicture, type PictureName } from "./pictures";

interface PictureButtonProps {
  chosen: string;
  taken: readonly string[];
  onChoose(name: PictureName): void;
}

/** The drawing as it is; pressed, it shows all of them below. Escape or a press elsewhere puts them away. */
export function PictureButton(props: PictureButtonProps) {
  const { classes } = texts.value;
  const place = useRef<HTMLDivElement>(null);
  const [open, setOpen] = useState(false);

  const put = () => {
    setOpen(false);
    place.current?.querySelector("button")?.focus();
  };
  // a press chooses and puts them away; arrow keys walk, Enter or Escape ends it
  const byHand = useRef(false);
  const choose = (name: PictureName) => {
    props.onChoose(name);
    if (byHand.current) put();
  };

  useLayoutEffect(() => {
    if (!open) return;
    const inside = place.current;
    inside?.querySelector<HTMLInputElement>("input:checked")?.focus();
    const leave = ({ target, type }: Event) => {
      if (type === "pointerdown") byHand.current = true;
      if (!inside?.contains(target as Node)) setOpen(false);
    };
    const end = (event: KeyboardEvent) => {
      byHand.current = false;
      if (event.key !== "Escape" && event.key !== "Enter") return;
      event.preventDefault();
      put();
    };
    document.addEventListener("pointerdown", leave);
    document.addEventListener("focusin", leave);
    inside?.addEventListener("keydown", end);
    return () => {
      document.removeEventListener("pointerdown", leave);
      document.removeEventListener("focusin", leave);
      inside?.removeEventListener("keydown", end);
    };
  }, [open]);

  const now = isPicture(props.chosen) ? classes.pictures[props.chosen] : classes.noPicture;
  return (
    <div class="picture-button" ref={place}>
      <button
        type="button"
        class="picture-button__button"
        aria-expanded={open}
        aria-label={classes.choosePicture(now)}
        title={classes.choosePicture(now)}
        data-testid={TEST.choosePicture}
        onClick={() => setOpen(!open)}
      >
        <GroupPicture name={props.chosen} />
        <ChevronDown class="icon picture-button__more" aria-hidden="true" />
      </button>
      {open && (
        <div class="picture-button__all card">
          <PictureChoice {...props} onChoose={choose} />
        </div>
      )}
    </div>
  );
}
