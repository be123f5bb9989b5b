import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { group, program, report } from "../app/session";
import { door, giveUpWaiting, knowDoor } from "../app/teacher";
import { DoorForm } from "../teacher/DoorForm";
import { Preparation } from "../teacher/Preparation";

/** What only the teacher sees: asks for the PIN first, and again when the door has shut, and keeps what is behind it. */
export function Behind({ children }: { children: ComponentChildren }) {
  const wasOpen = useRef(false);
  useEffect(() => {
    group.value = null;
    program.value = null;
    knowDoor().catch(report);
    return giveUpWaiting;
  }, []);
  const now = door.value;
  if (!now) return <main class="screen" aria-busy="true" />;
  if (!now.has_pin) return <Preparation onDone={() => {}} />;
  wasOpen.current ||= now.is_open;
  return (
    <>
      {!now.is_open && <DoorForm again={wasOpen.current} />}
      {wasOpen.current && (
        <div class="behind" hidden={!now.is_open}>
          {children}
        </div>
      )}
    </>
  );
}
