import { useRef } from "preact/hooks";
import type { BlocksReader } from "../../../editor/reader/reader";
import { texts } from "../../../i18n";
import { litBlock } from "../../../run/reducer";
import { report } from "../../../shell/session";
import { ReadBlocks } from "../../../versions/ReadBlocks";
import type { Side } from "./pair";

interface SideBlocksProps {
  side: Side;
  number: number;
  label: string;
}

/** The blocks of one of two runs, with the running block highlighted and the failed one outlined. */
export function SideBlocks({ side, number, label }: SideBlocksProps) {
  const place = useRef<HTMLDivElement>(null);
  const stop = useRef(() => {});
  const { version } = side.recording.run;
  if (!version) return <p class="compare__none">{texts.value.replay.noVersion}</p>;
  const fill = (reader: BlocksReader | null) => {
    stop.current();
    stop.current = () => {};
    if (!reader) return;
    try {
      reader.load(version.workspace);
    } catch (error) {
      report(error);
      return;
    }
    // the two block areas need distinct accessible names
    place.current
      ?.querySelector(".blocklyWorkspace")
      ?.setAttribute("aria-label", `${texts.value.review.compare.blocks} ${number}`);
    stop.current = side.view.subscribe((view) => {
      reader.point(litBlock(view));
      reader.fail(view.phase === "failed" ? (view.ending?.block ?? null) : null);
    });
  };
  return (
    <div class="compare__reader" ref={place}>
      <ReadBlocks label={label} onReader={fill} />
    </div>
  );
}
