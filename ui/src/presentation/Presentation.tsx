import { type Signal, useSignal } from "@preact/signals";
import { useLayoutEffect } from "preact/hooks";
import { texts } from "../i18n";
import { useInstance } from "../kit/instance";
import { isSolid, showSolid } from "../scene/tools/view_mode";
import { leave } from "../shell/projector/present";
import type { ParametersOf } from "../shell/route";
import { report } from "../shell/session";
import { prefersStill } from "../shell/theme";
import { KeyHelp } from "./KeyHelp";
import { type Action, listenToKeys } from "./keys";
import type { Presented } from "./load";
import { shownGroup, toggleNames } from "./names";
import { PresentControls } from "./PresentControls";
import { PresentedGroup } from "./PresentedGroup";
import { PresentedRun } from "./PresentedRun";
import { Steps } from "./steps";

interface PresentationProps {
  presented: Presented;
  route: ParametersOf<"presentation">;
}

/** A picture of runs that is read from the last row: blocks, floor, one sentence, groups. */
export function Presentation({ presented, route }: PresentationProps) {
  const { sides, groups, title } = presented;
  const isBlack = useSignal(false);
  const helps = useSignal(true);
  const act = useActions({ presented, route }, isBlack, helps);
  useLayoutEffect(() => listenToKeys(act), [act]);
  const isPair = sides.length > 1;
  const shown = sides.map(({ recordedRun: { run } }, place) =>
    shownGroup(run, place, groups, texts.value),
  );
  return (
    <main
      class={`screen presentation presentation--${isPair ? "pair" : "one"}`}
      data-testid="presentation"
      data-tick={presented.playback.tick.value}
      data-playing={presented.playback.playing.value}
    >
      <header class="presentation__head row middle gap-4">
        {!isPair && shown[0] && <PresentedGroup group={shown[0]} />}
        <h1 class={title ? "presentation__title shrinks one-line" : "visually-hidden"}>
          {title ?? texts.value.titles.presentation}
        </h1>
        <PresentControls playback={presented.playback} onAction={act} />
      </header>
      {sides.map((side, place) => {
        const group = shown[place];
        if (!group) return null;
        return (
          <PresentedRun key={side.recordedRun.run.id + place} {...{ side, place, group, isPair }} />
        );
      })}
      {helps.value && <KeyHelp />}
      {isBlack.value && <Black />}
    </main>
  );
}

function Black() {
  return (
    <div class="presentation__black" role="status" data-testid="presentation-black">
      <span class="visually-hidden">{texts.value.projector.isBlack}</span>
    </div>
  );
}

/** What keys and controls do. Any of them first shows a black picture again. */
function useActions(
  { presented, route }: PresentationProps,
  isBlack: Signal<boolean>,
  helps: Signal<boolean>,
): (action: Action) => void {
  return useInstance(() => {
    const { playback, sides } = presented;
    const tracks = sides.map(({ recordedRun }) => recordedRun.stretches);
    const steps = new Steps(playback, tracks, prefersStill);
    const acts: Record<Action, () => void> = {
      next: () => steps.next(),
      previous: () => steps.previous(),
      play: () => playback.toggle(),
      names: toggleNames,
      solid: () => showSolid(!isSolid.peek()),
      black: () => {
        isBlack.value = true;
      },
      help: () => {},
      leave: () => void leave(route).catch(report),
    };
    return (action: Action) => {
      const wasBlack = isBlack.peek();
      isBlack.value = false;
      helps.value = action === "help" && !helps.peek();
      if (!wasBlack) acts[action]();
    };
  });
}
