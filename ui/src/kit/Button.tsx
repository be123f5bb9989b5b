import type { ButtonHTMLAttributes, Ref, TargetedMouseEvent } from "preact";
import { useRef, useState } from "preact/hooks";
import { type FaceProps, faceOf, type OwnAttributes } from "./face";
import { settled } from "./report";

type Press = TargetedMouseEvent<HTMLButtonElement>;

export interface ButtonProps
  extends FaceProps,
    OwnAttributes,
    Omit<ButtonHTMLAttributes<HTMLButtonElement>, keyof FaceProps | keyof OwnAttributes> {
  /** It is switched on. */
  pressed?: boolean | undefined;
  /** What it opens is open. */
  open?: boolean | undefined;
  /** It stands for what is shown, in a list. */
  current?: boolean | "true" | "step" | undefined;
  /** What it began goes on: another press does nothing. */
  busy?: boolean | undefined;
  /** It sends its form. */
  submit?: boolean | undefined;
  /** While a promise that it returns is pending the button is busy; a failure is reported. */
  onPress?: ((event: Press) => unknown) | undefined;
  elementRef?: Ref<HTMLButtonElement> | undefined;
}

/** Everything that can be pressed. */
export function Button(props: ButtonProps) {
  const { attributes, contents, rest: own } = faceOf(props);
  const { pressed, open, current, busy, submit, onPress, elementRef, ...rest } = own;
  const press = usePress(onPress);
  const isBusy = busy || press.pending;
  return (
    <button
      {...rest}
      {...attributes}
      ref={elementRef ?? null}
      type={submit ? "submit" : "button"}
      aria-pressed={pressed}
      aria-expanded={open}
      aria-current={current}
      aria-busy={isBusy || busy}
      onClick={(event) => {
        if (isBusy) event.preventDefault();
        else press.now(event);
      }}
    >
      {contents}
    </button>
  );
}

function usePress(onPress: ((event: Press) => unknown) | undefined) {
  const [pending, setPending] = useState(false);
  const running = useRef(false); // two presses can come before the button is drawn again
  const now = (event: Press) => {
    if (running.current) return;
    const result = onPress?.(event);
    if (!(result instanceof Promise)) return;
    running.current = true;
    setPending(true);
    void settled(result).finally(() => {
      running.current = false;
      setPending(false);
    });
  };
  return { pending, now };
}
