import { Camera } from "lucide-preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { previewAddress } from "../api/camera";
import { texts } from "../i18n";
import { usePolling } from "../kit/usePolling";
import { CameraTrouble } from "./CameraTrouble";
import { Skeleton } from "./Skeleton";
import { aspect, camera, hasPicture, refresh } from "./sight";

/** A stream without pictures is ended by the server after 5 s. */
const AGAIN_MS = 4000;

/** What the camera sees, as in a mirror, with the hands drawn over it; or why there is nothing to see. */
export function CameraPicture() {
  const { mode, problem } = camera.value;
  // what is wrong with a picture that is there stands beside it
  const isShown = hasPicture.value && (mode === "on" || problem !== null);
  const state = isShown ? "on" : hasPicture.value ? mode : "failed";
  const { opening } = texts.value.camera;
  useEffect(() => void refresh().catch(() => {}), []); // a server that is gone has its own line
  return (
    <figure
      class="camera grid shrinks-down"
      data-testid="camera-picture"
      data-state={state}
      style={{ "--aspect": String(aspect.value) }}
    >
      <Preview shown={isShown} />
      {!isShown && problem && <CameraTrouble problem={problem} />}
      {!isShown && !problem && (
        <p class="camera__opening column middle center gap-2">
          <Camera class="icon" aria-hidden="true" />
          {opening}
        </p>
      )}
    </figure>
  );
}

/** The stream keeps the camera on, so it is asked for again and again where there is none. */
function Preview({ shown }: { shown: boolean }) {
  const [attempt, setAttempt] = useState(0);
  const isOn = camera.value.mode === "on";
  usePolling(() => setAttempt((before) => before + 1), { everyMs: AGAIN_MS, isOn: !isOn });
  return (
    <div class="camera__view" hidden={!shown}>
      <Stream key={attempt} attempt={attempt} />
      <Skeleton />
    </div>
  );
}

function Stream({ attempt }: { attempt: number }) {
  const picture = useRef<HTMLImageElement>(null);
  useEffect(() => {
    const { current } = picture;
    // a picture that has left the page may go on loading
    return () => current?.removeAttribute("src");
  }, []);
  return (
    <img
      ref={picture}
      src={previewAddress(attempt)}
      alt={texts.value.camera.picture}
      decoding="sync"
    />
  );
}
