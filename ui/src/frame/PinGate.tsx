import type { ComponentChildren } from "preact";
import { useEffect } from "preact/hooks";
import { lazy } from "../shell/lazy";
import { cancelWaiting, isPinAsked } from "../shell/teacher/teacher_session";

const SignInForm = lazy(async () => (await import("../teacher/sign_in/SignInForm")).SignInForm);

/**
 * For a screen that is for everybody, with an action for the teacher: asks for the PIN while the action waits for it.
 * The children stay mounted but hidden, with their input.
 */
export function PinGate({ children }: { children: ComponentChildren }) {
  useEffect(() => cancelWaiting, []);
  return (
    <>
      {isPinAsked.value && <SignInForm again={false} />}
      <div class="behind-pin" hidden={isPinAsked.value}>
        {children}
      </div>
    </>
  );
}
