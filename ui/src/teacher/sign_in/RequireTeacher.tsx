import type { ComponentChildren } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { Loaded } from "../../kit/requests/Loaded";
import { useLoaded } from "../../kit/requests/useLoaded";
import { group, program } from "../../shell/session";
import {
  cancelWaiting,
  loadTeacherSession,
  teacherSession,
} from "../../shell/teacher/teacher_session";
import { Preparation } from "./Preparation";
import { SignInForm } from "./SignInForm";

interface RequireTeacherProps {
  children: ComponentChildren;
}

/**
 * Shows its children only to the signed-in teacher. After the end of a session it asks for the PIN
 * again. The children stay mounted but hidden, with their input.
 */
export function RequireTeacher({ children }: RequireTeacherProps) {
  const [isPreparing, setPreparing] = useState(false);
  const wasSignedIn = useRef(false);
  const loaded = useLoaded("session", loadTeacherSession);
  const session = teacherSession.value;
  const isKnown = session?.has_pin || loaded.status === "ready"; // a PIN may have been set meanwhile
  useEffect(() => {
    group.value = null;
    program.value = null;
    return cancelWaiting;
  }, []);
  // shown until all steps are done; the PIN is only the first
  useEffect(() => {
    if (isKnown && session?.has_pin === false) setPreparing(true);
  }, [isKnown, session?.has_pin]);
  if (!session || !isKnown)
    return (
      <Loaded of={loaded} as="screen">
        {() => null}
      </Loaded>
    );
  if (isPreparing || !session.has_pin) return <Preparation onDone={() => setPreparing(false)} />;
  wasSignedIn.current ||= session.is_open;
  return (
    <>
      {!session.is_open && <SignInForm again={wasSignedIn.current} />}
      {wasSignedIn.current && (
        <div class="behind-pin" hidden={!session.is_open}>
          {children}
        </div>
      )}
    </>
  );
}
