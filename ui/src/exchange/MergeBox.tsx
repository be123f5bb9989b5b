import { type Signal, useSignal } from "@preact/signals";
import { Combine, RefreshCw } from "lucide-preact";
import { exchange, type Folder, type FoundFile, type Merged } from "../api/exchange";
import { report } from "../app/session";
import { asTeacher } from "../app/teacher";
import { TEST } from "../app/testids";
import { FolderFiles } from "./FolderFiles";
import { MergeResult } from "./MergeResult";
import { words } from "./words";

interface Properties {
  folders: readonly Folder[];
  results: Signal<Merged[]>;
  onMerged(): void;
  /** Look for sticks again, and for whose work is here. */
  onLook(): void;
}

/** Every file on every stick is to be merged, but those without names, and those that a person has unticked. */
export function MergeBox({ folders, results, onMerged, onLook }: Properties) {
  const ticked = useSignal<ReadonlyMap<string, boolean>>(new Map());
  const busy = useSignal<{ n: number; of: number } | null>(null);
  const say = words.value;
  const isChosen = (file: FoundFile) => ticked.value.get(file.path) ?? !file.anonymous;
  const chosen = folders
    .flatMap((folder) => folder.files.filter(isChosen))
    .map((file) => file.path);

  const mergeAll = async () => {
    results.value = [];
    try {
      for (const [n, path] of chosen.entries()) {
        busy.value = { n: n + 1, of: chosen.length };
        const merged = await asTeacher(() => exchange.merge(path));
        if (merged) results.value = [...results.value, merged];
      }
    } finally {
      busy.value = null;
      onMerged();
    }
  };
  const replace = (merged: Merged) => {
    results.value = results.value.map((one) => (one.path === merged.path ? merged : one));
  };
  /** Of another file all may have been here a moment ago; what went is told of it too. */
  const askAgain = async (deletedBy: string) => {
    for (const { path, nothing_new, problem } of results.value) {
      if (path === deletedBy || !nothing_new || problem) continue;
      const merged = await asTeacher(() => exchange.merge(path));
      if (merged) replace(merged);
    }
  };
  const deleteToo = async (path: string) => {
    const merged = await asTeacher(() => exchange.merge(path, true));
    if (merged) replace(merged);
    await askAgain(path);
    onMerged();
  };
  const toggle = (file: FoundFile) => {
    ticked.value = new Map(ticked.value).set(file.path, !isChosen(file));
  };

  return (
    <section class="exchange__box" aria-labelledby="exchange-places">
      <header class="exchange__head">
        <h2 id="exchange-places">{say.places}</h2>
        <button type="button" class="button button--plain" onClick={onLook}>
          <RefreshCw class="icon" aria-hidden="true" />
          {say.lookAgain}
        </button>
      </header>
      {folders.length === 0 && (
        <p class="exchange__empty">
          <strong>{say.nowhere}</strong> {say.nowhereHint}
        </p>
      )}
      {folders.map((folder) => (
        <FolderFiles key={folder.path} folder={folder} isChosen={isChosen} onToggle={toggle} />
      ))}
      {chosen.length > 0 && (
        <button
          type="button"
          class="button button--run exchange__act"
          data-testid={TEST.mergeFiles}
          disabled={busy.value !== null}
          onClick={() => void mergeAll().catch(report)}
        >
          <Combine class="icon" aria-hidden="true" />
          {busy.value ? say.merging(busy.value.n, busy.value.of) : say.merge(chosen.length)}
        </button>
      )}
      <div role="status" aria-label={say.results}>
        {results.value.length > 0 && (
          <ul class="exchange__results" data-testid={TEST.mergeResults}>
            {results.value.map((one) => (
              <MergeResult
                key={one.path}
                merged={one}
                onDelete={() => void deleteToo(one.path).catch(report)}
                onKeep={() => replace({ ...one, would_delete: null })}
              />
            ))}
          </ul>
        )}
      </div>
    </section>
  );
}
