import { useLayoutEffect } from "preact/hooks";
import { texts } from "../i18n";
import { labelled } from "../i18n/phrases";
import { useInstance } from "../kit/instance";
import { listenForKeys } from "../kit/listen";
import { ComparedBlocks } from "./compared_blocks";
import { DifferenceList } from "./DifferenceList";
import type { Compared } from "./differences";
import { ReadBlocks } from "./ReadBlocks";
import { SideChoice } from "./SideChoice";

interface DifferencesProps {
  compared: Compared;
  programId: string;
}

/** Two versions side by side, and the list of their differences. */
export function Differences({ compared, programId }: DifferencesProps) {
  const sides = useInstance(() => new ComparedBlocks(compared));
  const labels = texts.value.archive;
  useLayoutEffect(() => byKeys((by) => sides.step(by)), [sides]); // before painting, so that no key press is missed
  return (
    <main class="screen differences">
      <h1 class="visually-hidden">{labels.compareTitle}</h1>
      <section class="blocks">
        <SideChoice side="before" compared={compared} programId={programId} />
        <ReadBlocks
          label={labelled(labels.before, labels.version({ n: compared.before.number }))}
          onReader={(made) => {
            sides.before.value = made;
          }}
        />
      </section>
      <section class="blocks">
        <SideChoice side="after" compared={compared} programId={programId} />
        <ReadBlocks
          label={labelled(labels.after, labels.version({ n: compared.after.number }))}
          onReader={(made) => {
            sides.after.value = made;
          }}
          onLanguage={() => sides.redraw()}
        />
      </section>
      <DifferenceList sides={sides} programId={programId} />
    </main>
  );
}

/** Up and down step through the differences, unless the focused element uses these keys. */
function byKeys(step: (by: number) => void): () => void {
  return listenForKeys((key) => {
    const by = key === "ArrowDown" ? 1 : key === "ArrowUp" ? -1 : 0;
    if (by !== 0) step(by);
    return by !== 0;
  });
}
