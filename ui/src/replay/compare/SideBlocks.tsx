import { effect } from "@preact/signals";
import { useRef } from "preact/hooks";
import type { RunWithVersion } from "../../api/model";
import type { BlocksViewer } from "../../editor/reader/viewer";
import { texts } from "../../i18n";
import { activeBlockId, isLive, type RunView } from "../../run/reducer";
import { report } from "../../shell/session";
import { ReadBlocks } from "../../versions/ReadBlocks";
import type { PairBlocks } from "./load_pair";
import type { Side } from "./pair";

interface SideBlocksProps {
  side: Side;
  number: number;
  label: string;
  /**
   * The blocks of both runs, with their differences; null if the version of one run is not stored.
   */
  blocks: PairBlocks | null;
  minTextPx?: () => number;
}

/**
 * The blocks of one of two runs: differences decorated, running block highlighted, failed block
 * outlined.
 */
export function SideBlocks({ side, number, label, blocks, minTextPx }: SideBlocksProps) {
  const place = useRef<HTMLDivElement>(null);
  const stop = useRef(() => {});
  const { version } = side.recordedRun.run;
  if (!version) return <p class="compare__none">{texts.value.replay.noVersion}</p>;
  const drawnTogether = blocks && (number === 1 ? blocks.before : blocks.after);
  const fill = (viewer: BlocksViewer | null) => {
    stop.current();
    stop.current = () => {};
    if (drawnTogether) drawnTogether.value = viewer;
    else if (!viewer || !drawn(viewer, version.workspace)) return;
    if (!viewer) return;
    // the two block areas need distinct accessible names
    place.current
      ?.querySelector(".blocklyWorkspace")
      ?.setAttribute("aria-label", `${texts.value.review.compare.blocks} ${number}`);
    stop.current = effect(() => {
      blocks?.drawn.value;
      const { value: view } = side.view;
      // until somebody moves the clock, the current difference stays in view
      if (!side.isUntouched.value) viewer.point(activeBlockId(view));
      viewer.fail(faultyBlock(side.recordedRun.run, view));
    });
  };
  return (
    <div class="row grows shrinks" ref={place}>
      <ReadBlocks
        label={label}
        minTextPx={minTextPx}
        onReader={fill}
        onLanguage={() => blocks?.redraw()}
      />
    </div>
  );
}

/** The block at which the run failed, or at its end the one that the activity found lacking; null for none. */
function faultyBlock({ missing_block }: RunWithVersion, view: RunView): string | null {
  if (view.phase === "failed") return view.ending?.block ?? null;
  return isLive(view) ? null : missing_block;
}

function drawn(viewer: BlocksViewer, workspace: object): boolean {
  try {
    viewer.load(workspace);
    return true;
  } catch (error) {
    report(error);
    return false;
  }
}
