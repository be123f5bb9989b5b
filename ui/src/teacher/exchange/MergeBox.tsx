import { useSignal } from "@preact/signals";
import { Combine, RefreshCw } from "lucide-preact";
import { useRef } from "preact/hooks";
import type { FileFound, FolderList, KnownComputerList } from "../../api/model";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { FolderFiles } from "./FolderFiles";
import { MergedLessons } from "./MergedLessons";
import { MergeResult } from "./MergeResult";
import { OpenedFile } from "./OpenedFile";
import { Undecided } from "./Undecided";
import type { Merging } from "./useMerging";

interface MergeBoxProps {
  found: FolderList;
  merging: Merging;
  /** Deletions that wait for a decision. */
  undecided: KnownComputerList["undecided"];
  /** Reloads folders and known PCs. */
  onReload(): Promise<void>;
}

/**
 * Merges files of sticks. Initially the file with which PINEL was opened is selected, without one all
 * files except anonymous ones and those of this PC.
 */
export function MergeBox({
  found: { folders, opened },
  merging,
  undecided,
  onReload,
}: MergeBoxProps) {
  const ticked = useSignal<ReadonlyMap<string, boolean>>(new Map());
  const { progress, mergeAll } = merging;
  const labels = texts.value.exchange;
  const isChosen = ({ path, anonymous, own }: FileFound) =>
    ticked.value.get(path) ?? (opened?.file ? path === opened.file.path : !anonymous && !own);
  const found = [...(opened?.file ? [opened.file] : []), ...folders.flatMap(({ files }) => files)];
  // the opened file may be on a stick, too
  const chosen = [...new Set(found.filter(isChosen).map(({ path }) => path))];
  // also of a file that is no longer listed, as its result is shown
  const lessons = useRef(new Set<string>()).current;
  for (const { path, lesson } of found) if (lesson) lessons.add(path);
  const toggle = (file: FileFound) => {
    ticked.value = new Map(ticked.value).set(file.path, !isChosen(file));
  };
  return (
    <section class="panel card" aria-labelledby="exchange-places">
      <header class="button-row apart">
        <h2 id="exchange-places">{labels.places}</h2>
        <Button kind="plain" icon={RefreshCw} onPress={onReload}>
          {labels.lookAgain}
        </Button>
      </header>
      {opened && <OpenedFile opened={opened} isChosen={isChosen} onToggle={toggle} />}
      {folders.length === 0 && !opened && (
        <p>
          <strong>{labels.nowhere}</strong> {labels.nowhereHint}
        </p>
      )}
      {folders.map((folder) => (
        <FolderFiles key={folder.path} folder={folder} isChosen={isChosen} onToggle={toggle} />
      ))}
      {chosen.length > 0 && (
        <Button
          kind="main"
          class="exchange__merge"
          icon={Combine}
          testId="merge-files"
          onPress={() => mergeAll(chosen)}
        >
          {progress.value
            ? labels.merging({ n: progress.value.n, of: progress.value.of })
            : labels.merge({ count: chosen.length })}
        </Button>
      )}
      <Undecided deletions={undecided} onAsk={(path) => mergeAll([path])} />
      <Results merging={merging} lessons={lessons} />
    </section>
  );
}

interface ResultsProps {
  merging: Merging;
  /** Paths of lesson files. */
  lessons: ReadonlySet<string>;
}

function Results({ merging, lessons }: ResultsProps) {
  const { results, deleteToo, declineDeletion } = merging;
  return (
    <div role="status" aria-label={texts.value.exchange.results}>
      {results.value.length > 0 && (
        <ul class="grid gap-2" data-testid="merge-results">
          {results.value.map((one) => (
            <MergeResult
              key={one.path}
              merged={one}
              isLesson={lessons.has(one.path)}
              onDelete={(retained) => deleteToo(one.path, retained)}
              onDecline={() => declineDeletion(one)}
            />
          ))}
        </ul>
      )}
      <MergedLessons results={results.value} />
    </div>
  );
}
