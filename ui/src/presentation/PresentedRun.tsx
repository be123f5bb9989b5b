import { CapturedCard } from "../camera/CapturedCard";
import { texts } from "../i18n";
import { labelled } from "../i18n/phrases";
import type { Side } from "../replay/compare/pair";
import { SideBlocks } from "../replay/compare/SideBlocks";
import { ReplaySentence } from "../replay/ReplayParts";
import { Scene } from "../scene/Scene";
import { robotOf } from "../shell/session";
import type { ShownGroup } from "./names";
import { PresentedGroup } from "./PresentedGroup";
import { floorMagnification, textPx } from "./sizes";

interface PresentedRunProps {
  side: Side;
  place: number;
  group: ShownGroup;
  /** Whether another run is beside it. */
  isPair: boolean;
}

/** Blocks, floor and sentence of a run, large. */
export function PresentedRun({ side, place, group, isPair }: PresentedRunProps) {
  const { run } = side.recordedRun;
  const number = place + 1;
  const title = labelled(number, group.name);
  return (
    <section
      class="presentation__run"
      aria-label={title}
      data-testid="presentation-run"
      data-phase={side.view.value.phase}
      data-tick={side.view.value.tick}
    >
      {isPair && <PresentedGroup group={group} />}
      <div class="presentation__floor">
        <Scene
          world={run.world_document}
          robot={robotOf(run.model)}
          livery={isPair && group.livery ? { ...group.livery, name: "" } : group.livery}
          view={side.view}
          poseAt={side.pose}
          whole={side.recordedRun.playback.whole}
          playing={side.playing}
          magnification={floorMagnification}
        />
        <CapturedCard show={side.recordedRun.playback.show} />
      </div>
      <ReplaySentence run={run} view={side.view} beginning={({ projector }) => projector.begin} />
      <div class="presentation__blocks row">
        <SideBlocks
          side={side}
          number={number}
          blocks={null}
          label={texts.value.review.compare.blocksOf({ name: title })}
          minTextPx={textPx}
        />
      </div>
    </section>
  );
}
