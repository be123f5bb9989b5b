import { useRef } from "preact/hooks";
import { report } from "../app/session";
import type { BlocksReader } from "../editor/reader";
import { texts } from "../i18n";
import { words } from "../i18n/review";
import { litBlock } from "../run/reducer";
import { ReadBlocks } from "../versions/ReadBlocks";
import type { Side } from "./pair";

interface SideBlocksProps {
  side: Side;
  number: number;
  label: string;
}

/** The blocks of one of two runs, the running one lit, and outlined the one at which it broke off. */
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
    // two places with blocks are told apart by their names
    place.current
      ?.querySelector(".blocklyWorkspace")
      ?.setAttribute("aria-label", `${words.value.compare.blocks} ${number}`);
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
