import { useSignal } from "@preact/signals";
import { Combine, RefreshCw } from "lucide-preact";
import type { FileFound, Folder, KnownComputerList } from "../../api/model";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { FolderFiles } from "./FolderFiles";
import { MergeResult } from "./MergeResult";
import { Undecided } from "./Undecided";
import type { Merging } from "./useMerging";

interface MergeBoxProps {
  folders: readonly Folder[];
  merging: Merging;
  /** Deletions that wait for a decision. */
  undecided: KnownComputerList["undecided"];
  /** Reloads folders and known PCs. */
  onReload(): Promise<void>;
}

/** Merges files of sticks; all except anonymous files are selected initially. */
export function MergeBox({ folders, merging, undecided, onReload }: MergeBoxProps) {
  const ticked = useSignal<ReadonlyMap<string, boolean>>(new Map());
  const { results, progress, mergeAll, deleteToo, declineDeletion } = merging;
  const labels = texts.value.exchange;
  const isChosen = (file: FileFound) => ticked.value.get(file.path) ?? !file.anonymous;
  const chosen = folders.flatMap((folder) => folder.files.filter(isChosen));
  const found = folders.flatMap(({ files }) => files);
  const lessons = new Set(found.filter(({ lesson }) => lesson).map(({ path }) => path));
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
      {folders.length === 0 && (
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
          onPress={() => mergeAll(chosen.map(({ path }) => path))}
        >
          {progress.value
            ? labels.merging({ n: progress.value.n, of: progress.value.of })
            : labels.merge({ count: chosen.length })}
        </Button>
      )}
      <Undecided deletions={undecided} onAsk={(path) => mergeAll([path])} />
      <div role="status" aria-label={labels.results}>
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
      </div>
    </section>
  );
}
