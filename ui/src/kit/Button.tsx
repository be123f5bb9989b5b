import type { ButtonHTMLAttributes, Ref, TargetedMouseEvent } from "preact";
import { useRef, useState } from "preact/hooks";
import { type AppearanceProps, appearanceOf, type OwnAttributes } from "./appearance";
import { settled } from "./report";

type Press = TargetedMouseEvent<HTMLButtonElement>;

export interface ButtonProps
  extends AppearanceProps,
    OwnAttributes,
    Omit<ButtonHTMLAttributes<HTMLButtonElement>, keyof AppearanceProps | keyof OwnAttributes> {
  /** State of a toggle button. */
  pressed?: boolean | undefined;
  /** Whether the element that it controls is expanded. */
  open?: boolean | undefined;
  /** Marks the shown item of a list. */
  current?: boolean | "true" | "step" | undefined;
  /** Its action is pending; further presses have no effect. */
  busy?: boolean | undefined;
  /** Submits its form. */
  submit?: boolean | undefined;
  /** May return a promise: the button is busy until it settles, and a failure is reported. */
  onPress?: ((event: Press) => unknown) | undefined;
  elementRef?: Ref<HTMLButtonElement> | undefined;
}

/** A push button or toggle button. */
export function Button(props: ButtonProps) {
  const { attributes, contents, rest: own } = appearanceOf(props);
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
  const running = useRef(false); // a second press may come before the next render
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
