import { effect } from "@preact/signals";
import { useRef } from "preact/hooks";
import type { BlocksReader } from "../../editor/reader/reader";
import { texts } from "../../i18n";
import { litBlock } from "../../run/reducer";
import { report } from "../../shell/session";
import { ReadBlocks } from "../../versions/ReadBlocks";
import type { PairBlocks } from "./load_pair";
import type { Side } from "./pair";

interface SideBlocksProps {
  side: Side;
  number: number;
  label: string;
  /** The blocks of both runs, with their differences; null where those of one were not kept. */
  blocks: PairBlocks | null;
}

/** The blocks of one of two runs: differences marked, the running block highlighted and the failed one outlined. */
export function SideBlocks({ side, number, label, blocks }: SideBlocksProps) {
  const place = useRef<HTMLDivElement>(null);
  const stop = useRef(() => {});
  const { version } = side.recording.run;
  if (!version) return <p class="compare__none">{texts.value.replay.noVersion}</p>;
  const drawnTogether = blocks && (number === 1 ? blocks.before : blocks.after);
  const fill = (reader: BlocksReader | null) => {
    stop.current();
    stop.current = () => {};
    if (drawnTogether) drawnTogether.value = reader;
    else if (!reader || !drawn(reader, version.workspace)) return;
    if (!reader) return;
    // the two block areas need distinct accessible names
    place.current
      ?.querySelector(".blocklyWorkspace")
      ?.setAttribute("aria-label", `${texts.value.review.compare.blocks} ${number}`);
    stop.current = effect(() => {
      blocks?.drawn.value;
      const { value: view } = side.view;
      // before the clock runs, the difference that is shown stays in view
      if (view.tick > 0) reader.point(litBlock(view));
      reader.fail(view.phase === "failed" ? (view.ending?.block ?? null) : null);
    });
  };
  return (
    <div class="row grows shrinks" ref={place}>
      <ReadBlocks label={label} onReader={fill} onLanguage={() => blocks?.redraw()} />
    </div>
  );
}

function drawn(reader: BlocksReader, workspace: object): boolean {
  try {
    reader.load(workspace);
    return true;
  } catch (error) {
    report(error);
    return false;
  }
}
