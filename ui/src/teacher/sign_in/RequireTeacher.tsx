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
 * Shows its children to the teacher alone: asks for the PIN first, and again when the session has ended. The children
 * then stay mounted but hidden, with what was typed.
 */
export function RequireTeacher({ children }: RequireTeacherProps) {
  const [isPreparing, setPreparing] = useState(false);
  const wasSignedIn = useRef(false);
  const loaded = useLoaded("session", loadTeacherSession);
  const session = teacherSession.value;
  const isKnown = session?.has_pin || loaded.status === "ready"; // a PIN may have come meanwhile
  useEffect(() => {
    group.value = null;
    program.value = null;
    return cancelWaiting;
  }, []);
  // until all of it is done: the PIN is only its first step
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
        <div class="for-teacher" hidden={!session.is_open}>
          {children}
        </div>
      )}
    </>
  );
}
