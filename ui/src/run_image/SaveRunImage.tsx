import { useSignal } from "@preact/signals";
import { Film, Image, ImageDown, X } from "lucide-preact";
import { useEffect, useRef } from "preact/hooks";
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
  useEffect(() => () => ending.current?.abort(), [runId]);
  const { runImage } = texts.value;
  const savePicture = async () => (await import("./run_image")).savePicture(runId);
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
  if (done.value !== null) {
    return <Making part={done.value} onCancel={() => ending.current?.abort()} />;
  }
  return (
    <div class={`run-image run-image--${opens}`}>
      <PopupButton
        label={runImage.save}
        testId="run-image"
        class="run-image__button"
        face={
          <>
            <ImageDown class="icon" aria-hidden="true" />
            <span class="run-image__text">{runImage.save}</span>
          </>
        }
      >
        {() => (
          <div class="column gap-2">
            <Choice
              Icon={Image}
              title={runImage.picture}
              hint={runImage.pictureHint}
              testId="save-run-picture"
              onPress={savePicture}
            />
            <Choice
              Icon={Film}
              title={runImage.animation}
              hint={runImage.animationHint}
              testId="save-run-animation"
              onPress={saveAnimation}
            />
          </div>
        )}
      </PopupButton>
    </div>
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
    <div class="run-image__making row middle gap-2">
      <span class="one-line" role="status" data-testid="run-image-progress">
        {runImage.making({ part: percent(part, language.value) })}
      </span>
      <Button icon={X} label={runImage.cancel} testId="run-image-cancel" onPress={onCancel} />
    </div>
  );
}
