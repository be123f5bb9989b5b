import { Camera } from "lucide-preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { previewAddress } from "../api/camera";
import { texts } from "../i18n";
import { usePolling } from "../kit/usePolling";
import { CameraTrouble } from "./CameraTrouble";
import { Skeleton } from "./Skeleton";
import { aspect, camera, hasPicture, refresh } from "./sight";

/** Shorter than the 5 s after which the server ends a stream without frames. */
const AGAIN_MS = 4000;

/**
 * The mirrored live picture with the detected hands drawn over it, or the problem that prevents it.
 */
export function CameraPicture() {
  const { mode, problem } = camera.value;
  // if there is a picture, its problem is shown beside it by CurrentSign
  const isShown = hasPicture.value && (mode === "on" || problem !== null);
  const state = isShown ? "on" : hasPicture.value ? mode : "failed";
  const { opening } = texts.value.camera;
  useEffect(() => void refresh().catch(() => {}), []); // Messages reports an unreachable server
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

/**
 * The live picture. While the camera is not on, requests the stream repeatedly: the request itself
 * switches the camera on.
 */
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
    // the browser may continue to load an image that was removed from the page
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
