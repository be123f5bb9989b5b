import { type Signal, signal } from "@preact/signals";
import { useLayoutEffect } from "preact/hooks";
import { useInstance } from "../kit/instance";
import { leave, type Presentation } from "../shell/projector/present";
import { report } from "../shell/session";
import { type Action, listenToKeys } from "./keys";
import { toggleNames } from "./names";

/** What stands over a presentation, and what keys and controls do. */
export interface Picture {
  readonly isBlack: Signal<boolean>;
  /** Whether the keys are shown: until one of them is pressed. */
  readonly helps: Signal<boolean>;
  act(action: Action): void;
}

/** Any key or control first shows a black picture again. `own` makes what only this presentation does. */
export function usePicture(
  shown: Presentation,
  own: () => Partial<Record<Action, () => void>>,
): Picture {
  const picture = useInstance(() => {
    const [isBlack, helps] = [signal(false), signal(true)];
    const acts: Partial<Record<Action, () => void>> = {
      ...own(),
      names: toggleNames,
      black: () => {
        isBlack.value = true;
      },
      leave: () => void leave(shown).catch(report),
    };
    const act = (action: Action) => {
      const wasBlack = isBlack.peek();
      isBlack.value = false;
      helps.value = action === "help" && !helps.peek();
      if (!wasBlack) acts[action]?.();
    };
    return { isBlack, helps, act };
  });
  useLayoutEffect(() => listenToKeys(picture.act), [picture]);
  return picture;
}
