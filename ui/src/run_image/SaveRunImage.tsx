import { useSignal } from "@preact/signals";
import { Film, Image, ImageDown, X } from "lucide-preact";
import type { RefObject } from "preact";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";
import { language, texts } from "../i18n";
import { percent } from "../i18n/format";
import { Button } from "../kit/Button";
import { PopupButton } from "../kit/pictures/PopupButton";

interface SaveRunImageProps {
  /** The run, which must be over. */
  runId: string;
  /** On which side of the button its choices open. */
  opens: "above" | "below";
}

/** Saves a run as a picture or as an animation, which takes some seconds and can be cancelled. */
export function SaveRunImage({ runId, opens }: SaveRunImageProps) {
  const done = useSignal<number | null>(null);
  const ending = useRef<AbortController | null>(null);
  const place = useRef<HTMLDivElement>(null);
  const isMaking = done.value !== null;
  useEffect(() => () => ending.current?.abort(), [runId]);
  useFocusInside(place, isMaking);
  const saveAnimation = async () => {
    const controller = new AbortController();
    ending.current = controller;
    done.value = 0;
    try {
      const { saveAnimation: save } = await import("./run_image");
      await save(runId, {
        signal: controller.signal,
        onProgress: (part) => {
          done.value = part;
        },
      });
    } finally {
      done.value = null;
    }
  };
  return (
    <div class={`run-image run-image--${opens}`} ref={place}>
      {isMaking ? (
        <Making part={done.value ?? 0} onCancel={() => ending.current?.abort()} />
      ) : (
        <Choices runId={runId} onAnimation={saveAnimation} />
      )}
    </div>
  );
}

/** Keeps the focus at the button when it is replaced by the progress, and back. */
function useFocusInside(place: RefObject<HTMLElement>, isMaking: boolean): void {
  const before = useRef(isMaking);
  useLayoutEffect(() => {
    if (before.current === isMaking) return;
    before.current = isMaking;
    if (document.activeElement === document.body) {
      place.current?.querySelector("button")?.focus({ preventScroll: true });
    }
  }, [isMaking]);
}

interface ChoicesProps {
  runId: string;
  onAnimation(): Promise<void>;
}

function Choices({ runId, onAnimation }: ChoicesProps) {
  const { runImage } = texts.value;
  const face = (
    <>
      <ImageDown class="icon" aria-hidden="true" />
      <span class="run-image__text">{runImage.save}</span>
    </>
  );
  return (
    <PopupButton label={runImage.save} testId="run-image" class="run-image__button" face={face}>
      {(_pressed, close) => (
        <div class="column gap-2">
          <Choice
            Icon={Image}
            title={runImage.picture}
            hint={runImage.pictureHint}
            testId="save-run-picture"
            onPress={async () => {
              await (await import("./run_image")).savePicture(runId);
              close();
            }}
          />
          <Choice
            Icon={Film}
            title={runImage.animation}
            hint={runImage.animationHint}
            testId="save-run-animation"
            onPress={onAnimation}
          />
        </div>
      )}
    </PopupButton>
  );
}

interface ChoiceProps {
  Icon: typeof Film;
  title: string;
  hint: string;
  testId: string;
  onPress(): Promise<void>;
}

function Choice({ Icon, title, hint, testId, onPress }: ChoiceProps) {
  return (
    <Button
      kind="bare"
      class="run-image__choice row middle gap-3"
      testId={testId}
      onPress={onPress}
    >
      <Icon class="icon" aria-hidden="true" />
      <span>
        <strong>{title}</strong>
        <span class="aside run-image__hint">{hint}</span>
      </span>
    </Button>
  );
}

/** How much of the animation is made, and the button that ends it. */
function Making({ part, onCancel }: { part: number; onCancel(): void }) {
  const { runImage } = texts.value;
  return (
    <div class="row middle gap-2">
      <span
        class="one-line"
        role="progressbar"
        aria-label={runImage.animation}
        aria-valuenow={Math.round(100 * part)}
        data-testid="run-image-progress"
      >
        {runImage.making({ part: percent(part, language.value) })}
      </span>
      <Button icon={X} label={runImage.cancel} testId="run-image-cancel" onPress={onCancel} />
    </div>
  );
}
