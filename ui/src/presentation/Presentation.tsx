import { texts } from "../i18n";
import { isSolid, showSolid } from "../scene/tools/view_mode";
import type { ParametersOf } from "../shell/route";
import { prefersStill } from "../shell/theme";
import { RUN_ACTIONS } from "./keys";
import type { Presented } from "./load";
import { shownGroup } from "./names";
import { PictureCover } from "./PictureCover";
import { PresentControls } from "./PresentControls";
import { PresentedGroup } from "./PresentedGroup";
import { PresentedRun } from "./PresentedRun";
import { usePicture } from "./picture";
import { Steps } from "./steps";

interface PresentationProps {
  presented: Presented;
  route: ParametersOf<"presentation">;
}

/** A picture of runs that is read from the last row: blocks, floor, one sentence, groups. */
export function Presentation({ presented, route }: PresentationProps) {
  const { sides, groups, title } = presented;
  const picture = usePicture({ screen: "presentation", ...route }, () => actsOf(presented));
  const isPair = sides.length > 1;
  const shown = sides.map(({ recordedRun: { run } }, place) =>
    shownGroup(run.group_id, place, groups, texts.value),
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
        <PresentControls playback={presented.playback} onAction={picture.act} />
      </header>
      {sides.map((side, place) => {
        const group = shown[place];
        if (!group) return null;
        return (
          <PresentedRun key={side.recordedRun.run.id + place} {...{ side, place, group, isPair }} />
        );
      })}
      <PictureCover picture={picture} actions={RUN_ACTIONS} />
    </main>
  );
}

/** What only a presentation of runs does. */
function actsOf({ playback, sides }: Presented) {
  const tracks = sides.map(({ recordedRun }) => recordedRun.stretches);
  const steps = new Steps(playback, tracks, prefersStill);
  return {
    next: () => steps.next(),
    previous: () => steps.previous(),
    play: () => playback.toggle(),
    solid: () => showSolid(!isSolid.peek()),
  };
}
