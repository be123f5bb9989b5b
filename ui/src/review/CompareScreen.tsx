import { type Signal, useComputed, useSignal } from "@preact/signals";
import { ArrowLeft } from "lucide-preact";
import { useEffect, useState } from "preact/hooks";
import { api } from "../api/client";
import type { Group } from "../api/model";
import { reviewPlace } from "../app/review_place";
import { hashOf } from "../app/route";
import { report } from "../app/session";
import { TEST } from "../app/testids";
import { language, texts } from "../i18n";
import { duration } from "../i18n/format";
import { words } from "../i18n/review";
import { Readout } from "../run/Readout";
import type { Companion } from "../scene/companion";
import { Scene } from "../scene/Scene";
import { GroupPicture } from "../screens/GroupPicture";
import { NotOpened } from "../screens/NotOpened";
import { ReplayWords } from "../screens/ReplayParts";
import { loadRecording } from "../screens/recording";
import { Transport } from "../screens/Transport";
import { Behind } from "./Behind";
import { outcomeOf } from "./model";
import { Pair, type Side } from "./pair";
import { SideBlocks } from "./SideBlocks";
import { Sign } from "./Sign";

type View = "apart" | "together";

interface Loaded {
  pair: Pair;
  groups: readonly Group[];
}

/** Two runs side by side on one clock. */
export function CompareScreen({ runs }: { runs: readonly [string, string] }) {
  return (
    <Behind>
      <Opened runs={runs} />
    </Behind>
  );
}

function Opened({ runs: [first, second] }: { runs: readonly [string, string] }) {
  const [loaded, setLoaded] = useState<Loaded | null>(null);
  const [failed, setFailed] = useState(false);
  useEffect(() => {
    let left = false;
    let made: Pair | null = null;
    Promise.all([loadRecording(first), loadRecording(second), api.groups()]).then(
      ([one, other, groups]) => {
        if (left) return;
        made = new Pair(one, other);
        setLoaded({ pair: made, groups });
      },
      (error) => {
        setFailed(true);
        report(error);
      },
    );
    return () => {
      left = true;
      made?.dispose();
    };
  }, [first, second]);
  if (failed) return <NotOpened />;
  if (!loaded) {
    return (
      <main class="screen studio studio--opening" aria-busy="true">
        <p>{words.value.compare.opening}</p>
      </main>
    );
  }
  return <Compare {...loaded} />;
}

function Compare({ pair, groups }: Loaded) {
  const { compare } = words.value;
  const view = useSignal<View>("apart");
  const together = view.value === "together";
  const [first, second] = pair.sides;
  const from = reviewPlace.value ?? { screen: "runs" };
  const back = from.screen === "runs" ? compare.back : texts.value.header.backToLesson;
  return (
    <main class={`screen replay compare compare--${view.value}`} data-testid={TEST.comparePage}>
      <div class="compare__head">
        <a class="button button--icon" href={hashOf(from)} aria-label={back} title={back}>
          <ArrowLeft class="icon" aria-hidden="true" />
        </a>
        <h1>{compare.title}</h1>
        {together && <Elsewhere sides={pair.sides} />}
        <ViewChoice view={view} />
      </div>
      {together && <OneFloor first={first} second={second} />}
      {pair.sides.map((side, index) => (
        <SidePane
          key={side.recording.run.id + index}
          side={side}
          number={index + 1}
          groups={groups}
          together={together}
        />
      ))}
      <Transport
        playback={pair.playback}
        tracks={pair.sides.map(({ recording }) => recording.stretches)}
      />
    </main>
  );
}

/** In one floor the second path may lie where its walls never stood. */
function Elsewhere({ sides }: { sides: readonly [Side, Side] }) {
  const [first, second] = sides.map(({ recording }) => recording.run.world_document?.name);
  if (first === second) return null;
  return <p class="compare__elsewhere">{words.value.compare.otherWorld}</p>;
}

function ViewChoice({ view }: { view: Signal<View> }) {
  const { compare } = words.value;
  return (
    <fieldset class="switch">
      <legend class="switch__word">{compare.view}</legend>
      {(["apart", "together"] as const).map((name) => (
        <button
          key={name}
          type="button"
          class="button"
          aria-pressed={view.value === name}
          data-testid={TEST.compareView}
          data-value={name}
          onClick={() => {
            view.value = name;
          }}
        >
          {compare[name]}
        </button>
      ))}
    </fieldset>
  );
}

function OneFloor({ first, second }: { first: Side; second: Side }) {
  const companion = useComputed<Companion>(() => ({
    world: second.recording.run.world_document,
    view: second.view.value,
    pose: second.pose,
  }));
  return (
    <div class="compare__floor">
      <Scene
        world={first.recording.run.world_document}
        view={first.view}
        poseAt={first.pose}
        companion={companion}
      />
    </div>
  );
}

interface SidePaneProps {
  side: Side;
  number: number;
  groups: readonly Group[];
  together: boolean;
}

/** One of the two: whose it is, its floor, what the robot does, its blocks and where the robot is. */
function SidePane({ side, number, groups, together }: SidePaneProps) {
  const { compare } = words.value;
  const { run } = side.recording;
  const group = groups.find(({ id }) => id === run.group_id);
  const title = [group?.name, run.program_name].filter(Boolean).join(" · ");
  return (
    <section
      class={`compare__side compare__side--${number} tinted`}
      style={group ? { "--group": group.color } : {}}
      aria-label={`${number}: ${title}`}
      data-testid={TEST.compareSide}
      data-phase={side.view.value.phase}
      data-tick={side.view.value.tick}
    >
      <SideHead side={side} group={group} number={number} swatch={together} />
      {!together && (
        <div class="compare__scene">
          <Scene world={run.world_document} view={side.view} poseAt={side.pose} />
        </div>
      )}
      <ReplayWords run={run} view={side.view} />
      <div class="compare__blocks">
        <SideBlocks
          key={String(together)}
          side={side}
          number={number}
          label={compare.blocksOf(`${number}: ${title}`)}
        />
      </div>
      <div class="floor__foot card" title={compare.pathOf(title)}>
        <Readout view={side.view} />
      </div>
    </section>
  );
}

interface SideHeadProps {
  side: Side;
  group: Group | undefined;
  number: number;
  /** How its path is drawn on the one floor. */
  swatch: boolean;
}

function SideHead({ side, group, number, swatch }: SideHeadProps) {
  const { outcomes, runs } = words.value;
  const { run } = side.recording;
  const outcome = outcomeOf(run);
  const took = run.duration_s === null ? "" : ` · ${duration(run.duration_s, language.value)}`;
  return (
    <h2 class="compare__title">
      <GroupPicture name={group?.picture ?? ""} class="compare__picture" />
      <span class="compare__name">{group?.name ?? runs.commandLine}</span>
      <span class="compare__program">{run.program_name}</span>
      <span class="compare__outcome">
        <Sign outcome={outcome} />
        {outcomes[outcome]}
        {took}
      </span>
      {swatch && (
        <svg
          class={`compare__swatch compare__swatch--${number}`}
          viewBox="0 0 36 8"
          aria-hidden="true"
        >
          <path d="M2 4h32" />
        </svg>
      )}
    </h2>
  );
}
