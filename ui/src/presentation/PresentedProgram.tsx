import { effect, type Signal, useSignal } from "@preact/signals";
import { useRef } from "preact/hooks";
import type { BlocksViewer } from "../editor/reader/viewer";
import { texts } from "../i18n";
import type { ParametersOf } from "../shell/route";
import { report } from "../shell/session";
import { ReadBlocks } from "../versions/ReadBlocks";
import { PROGRAM_ACTIONS } from "./keys";
import { shownGroup } from "./names";
import { PictureCover } from "./PictureCover";
import { PresentControls } from "./PresentControls";
import { PresentedGroup } from "./PresentedGroup";
import { usePicture } from "./picture";
import type { ProgramToPresent } from "./program";
import { textPx } from "./sizes";

interface PresentedProgramProps {
  program: ProgramToPresent;
  route: ParametersOf<"presentedprogram">;
}

/** The blocks of a program, large. Steps point at one block after the other. */
export function PresentedProgram({ program, route }: PresentedProgramProps) {
  const { name, groupId, groups, blocks } = program;
  const at = useSignal(-1);
  const picture = usePicture({ screen: "presentedprogram", ...route }, () => ({
    next: () => step(at, 1, blocks.length),
    previous: () => step(at, -1, blocks.length),
  }));
  return (
    <main class="screen presentation presentation--program" data-testid="presentation">
      <header class="presentation__head row middle gap-4">
        <PresentedGroup group={shownGroup(groupId, 0, groups, texts.value)} />
        <h1 class="presentation__title shrinks one-line" dir="auto">
          {name}
        </h1>
        <PresentControls playback={null} onAction={picture.act} />
      </header>
      <div class="presentation__blocks row">
        <Blocks program={program} at={at} />
      </div>
      <PictureCover picture={picture} actions={PROGRAM_ACTIONS} />
    </main>
  );
}

/** Goes to another block; from -1, before the first one. */
function step(at: Signal<number>, by: -1 | 1, count: number): void {
  at.value = Math.max(-1, Math.min(count - 1, at.peek() + by));
}

function Blocks({ program, at }: { program: ProgramToPresent; at: Signal<number> }) {
  const { name, workspace, blocks } = program;
  const stop = useRef(() => {});
  const fill = (viewer: BlocksViewer | null) => {
    stop.current();
    stop.current = () => {};
    if (!viewer || !workspace) return;
    try {
      viewer.load(workspace);
    } catch (error) {
      report(error);
      return;
    }
    stop.current = effect(() => viewer.point(blocks[at.value] ?? null));
  };
  return (
    <ReadBlocks
      label={texts.value.review.compare.blocksOf({ name })}
      minTextPx={textPx}
      onReader={fill}
    />
  );
}
