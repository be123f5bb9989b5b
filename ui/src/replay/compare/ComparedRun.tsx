import { Lightbulb } from "lucide-preact";
import type { Group } from "../../api/model";
import { language, texts } from "../../i18n";
import { duration } from "../../i18n/format";
import { hintsRead, labelled } from "../../i18n/phrases";
import { GroupPicture } from "../../kit/pictures/GroupPicture";
import { Readout } from "../../run/panels/Readout";
import { RobotName } from "../../run/real/RobotName";
import { liveryOf } from "../../scene/livery/livery";
import { Scene } from "../../scene/Scene";
import { robotOf } from "../../shell/session";
import { outcomeOf } from "../../teacher/review/model";
import { OutcomeIcon } from "../../teacher/review/OutcomeIcon";
import { ReplaySentence } from "../ReplayParts";
import type { PairBlocks } from "./load_pair";
import type { Side } from "./pair";
import { SideBlocks } from "./SideBlocks";

interface ComparedRunProps {
  side: Side;
  number: number;
  groups: readonly Group[];
  together: boolean;
  blocks: PairBlocks | null;
}

/** One of two runs: group, floor, blocks and robot pose. */
export function ComparedRun({ side, number, groups, together, blocks }: ComparedRunProps) {
  const { compare } = texts.value.review;
  const { run } = side.recordedRun;
  const group = groups.find(({ id }) => id === run.group_id);
  const title = [group?.name, run.program_name].filter(Boolean).join(" · ");
  return (
    <section
      class={`compare__side shrinks shrinks-down compare__side--${number} tinted`}
      style={group ? { "--group": group.color } : {}}
      aria-label={labelled(number, title)}
      data-testid="compare-side"
      data-phase={side.view.value.phase}
      data-tick={side.view.value.tick}
    >
      <RunHead side={side} group={group} number={number} swatch={together} />
      {!together && (
        <div class="compare__scene">
          <Scene
            world={run.world_document}
            robot={robotOf(run.model)}
            livery={liveryOf(group)}
            view={side.view}
            poseAt={side.pose}
            whole={side.recordedRun.playback.whole}
            playing={side.playing}
          />
        </div>
      )}
      <ReplaySentence run={run} view={side.view} beginning={({ replay }) => replay.begin} />
      <div class="compare__blocks row shrinks-down">
        <SideBlocks
          key={String(together)}
          side={side}
          number={number}
          blocks={blocks}
          label={compare.blocksOf({ name: labelled(number, title) })}
        />
      </div>
      <div class="floor__foot card" title={compare.pathOf({ name: title })}>
        <Readout view={side.view} />
      </div>
    </section>
  );
}

/** How many hints of the activity were open when the program ran. */
function HintsOpened({ side }: Pick<RunHeadProps, "side">) {
  const setup = side.recordedRun.run.version?.setup;
  if (!setup?.activity) return null;
  const label = hintsRead(setup.n_hints, texts.value);
  return (
    <span class="compare__hints row middle" title={label} data-testid="compare-hints">
      <Lightbulb class="icon" aria-hidden="true" />
      <span aria-hidden="true">{setup.n_hints}</span>
      <span class="visually-hidden">{label}</span>
    </span>
  );
}

interface RunHeadProps {
  side: Side;
  group: Group | undefined;
  number: number;
  /** Whether to show the line style of the run's path on the shared floor. */
  swatch: boolean;
}

function RunHead({ side, group, number, swatch }: RunHeadProps) {
  const { outcomes, runs } = texts.value.review;
  const { run } = side.recordedRun;
  const outcome = outcomeOf(run);
  const took = run.duration_s === null ? "" : ` · ${duration(run.duration_s, language.value)}`;
  return (
    <h2 class="compare__title row middle gap-2">
      <GroupPicture name={group?.picture ?? ""} class="compare__picture" />
      <span class="compare__name" data-shortened title={group?.name}>
        {group?.name ?? runs.commandLine}
      </span>
      <span class="compare__program" data-shortened title={run.program_name ?? undefined}>
        {run.program_name}
      </span>
      <RobotName link={run.link} calibrated={run.calibrated_robot} />
      <span class="compare__outcome">
        <OutcomeIcon outcome={outcome} />
        {outcomes[outcome]}
        {took}
        <HintsOpened side={side} />
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
