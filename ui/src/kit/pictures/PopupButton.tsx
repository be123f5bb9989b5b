import { ChevronDown } from "lucide-preact";
import type { ComponentChildren, RefObject } from "preact";
import { useLayoutEffect, useRef, useState } from "preact/hooks";
import { Button } from "../Button";

interface PopupButtonProps {
  label: string;
  testId: string;
  class?: string;
  /** What the button shows. */
  face: ComponentChildren;
  /**
   * The content of the popup. `pressed` closes it after a press with the pointer, for a choice that
   * ends it; `close` closes it in any case, for an action.
   */
  children(pressed: () => void, close: () => void): ComponentChildren;
}

/** A button that opens a card below. Escape, Enter or a press elsewhere closes the card. */
export function PopupButton({
  label,
  testId,
  class: extra = "",
  face,
  children,
}: PopupButtonProps) {
  const place = useRef<HTMLDivElement>(null);
  const [open, setOpen] = useState(false);
  const close = (withFocus: boolean) => {
    setOpen(false);
    if (withFocus) place.current?.querySelector("button")?.focus();
  };
  const byHand = usePopup(place, open, close);
  const pressed = () => {
    if (byHand.current) close(true);
  };
  return (
    <div class="popup-button" ref={place}>
      <Button
        kind="bare"
        class={`popup-button__button ${extra}`}
        open={open}
        label={label}
        tip={label}
        testId={testId}
        onPress={() => setOpen(!open)}
      >
        {face}
        <ChevronDown class="icon popup-button__more" aria-hidden="true" />
      </Button>
      {open && <div class="popup-button__card card">{children(pressed, () => close(true))}</div>}
    </div>
  );
}

/** Whether Enter presses a button in the card. */
const isAction = (target: EventTarget | null) =>
  target instanceof Element && target.closest(".popup-button__card button") !== null;

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
    inside.querySelector<HTMLInputElement>("input:checked")?.focus({ preventScroll: true });
    inside.querySelector(".popup-button__card")?.scrollIntoView({ block: "nearest" });
    const leave = ({ target, type }: Event) => {
      if (type === "pointerdown") byHand.current = true;
      if (!inside.contains(target as Node)) close(false);
    };
    const end = (event: KeyboardEvent) => {
      byHand.current = false;
      if (event.key !== "Escape" && event.key !== "Enter") return;
      if (event.key === "Enter" && isAction(event.target)) return;
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
