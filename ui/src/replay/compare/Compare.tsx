import { type Signal, useComputed, useSignal } from "@preact/signals";
import { ArrowLeft } from "lucide-preact";
import type { ComponentChildren } from "preact";
import type { Group } from "../../api/model";
import { texts } from "../../i18n";
import { LinkButton } from "../../kit/LinkButton";
import { RadioGroup } from "../../kit/RadioGroup";
import type { Companion } from "../../scene/companion";
import { type Livery, liveryOf } from "../../scene/livery/livery";
import { Scene } from "../../scene/Scene";
import { PresentButton } from "../../shell/projector/PresentButton";
import { hashOf } from "../../shell/route";
import { robotOf } from "../../shell/session";
import { reviewOrigin } from "../../shell/teacher/review_origin";
import { PlaybackControls } from "../PlaybackControls";
import { ComparedRun } from "./ComparedRun";
import type { LoadedPair } from "./load_pair";
import { PairDifferences } from "./PairDifferences";
import type { Pair, Side } from "./pair";

type View = "apart" | "together";

/**
 * Two runs on two floors or overlaid on one, their blocks with decorated differences, and playback
 * controls.
 */
export function Compare({ pair, groups, blocks, isOneProgram }: LoadedPair) {
  const view = useSignal<View>(inOneWorld(pair) ? "together" : "apart");
  const isTogether = view.value === "together";
  return (
    <main class={`screen replay compare compare--${view.value}`} data-testid="compare-page">
      <Head pair={pair} view={view}>
        {blocks && <PairDifferences blocks={blocks} isOneProgram={isOneProgram} />}
      </Head>
      {isTogether && <OneFloor pair={pair} liveries={liveriesOf(pair, groups)} />}
      {pair.sides.map((side, index) => (
        <ComparedRun
          key={side.recordedRun.run.id + index}
          side={side}
          number={index + 1}
          groups={groups}
          blocks={blocks}
          together={isTogether}
        />
      ))}
      <PlaybackControls
        playback={pair.playback}
        tracks={pair.sides.map(({ recordedRun }) => recordedRun.stretches)}
      />
    </main>
  );
}

/** Paths in one world are on one floor at first, which is larger than two. */
function inOneWorld({ sides: [first, second] }: Pair): boolean {
  const nameOf = ({ recordedRun }: Side) => recordedRun.run.world_document?.name;
  return nameOf(first) === nameOf(second);
}

interface HeadProps {
  pair: Pair;
  children: ComponentChildren;
  view: Signal<View>;
}

function Head({ pair, view, children }: HeadProps) {
  const { compare: labels } = texts.value.review;
  const from = reviewOrigin.value ?? { screen: "runs" };
  const back = from.screen === "runs" ? labels.back : texts.value.header.backToLesson;
  const [first, second] = [pair.sides[0].recordedRun.run.id, pair.sides[1].recordedRun.run.id];
  return (
    <div class="review-head compare__head row middle gap-4">
      <LinkButton icon={ArrowLeft} label={back} href={hashOf(from)} />
      <h1>{labels.title}</h1>
      {children}
      {/* the floor shows the first world, so the second path may cross its walls */}
      {view.value === "together" && !inOneWorld(pair) && (
        <p class="compare__elsewhere">{labels.otherWorld}</p>
      )}
      <PresentButton first={first} second={second} />
      <RadioGroup<View>
        class="switch row middle shrinks"
        label={labels.view}
        legendClass="switch__word"
        optionClass=""
        testId="compare-view"
        value={view.value}
        options={[
          ["apart", labels.apart],
          ["together", labels.together],
        ]}
        onChange={(chosen) => {
          view.value = chosen;
        }}
      />
    </div>
  );
}

/** The liveries of both robots. The second of two runs of one group has the colour of its path instead. */
function liveriesOf({ sides }: Pair, groups: readonly Group[]): [Livery | null, Livery | null] {
  const [first, second] = sides.map(({ recordedRun: { run } }) =>
    groups.find(({ id }) => id === run.group_id),
  );
  return [liveryOf(first), first === second ? null : liveryOf(second)];
}

interface OneFloorProps {
  pair: Pair;
  liveries: readonly [Livery | null, Livery | null];
}

function OneFloor({ pair: { sides }, liveries }: OneFloorProps) {
  const [first, second] = sides;
  const companion = useComputed<Companion>(() => ({
    world: second.recordedRun.run.world_document,
    robot: robotOf(second.recordedRun.run.model),
    livery: liveries[1],
    view: second.view.value,
    pose: second.pose,
  }));
  return (
    <div class="compare__floor shrinks shrinks-down">
      <Scene
        world={first.recordedRun.run.world_document}
        robot={robotOf(first.recordedRun.run.model)}
        livery={liveries[0]}
        view={first.view}
        poseAt={first.pose}
        playing={first.playing}
        companion={companion}
      />
    </div>
  );
}
