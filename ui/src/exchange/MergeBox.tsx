import { type Signal, useSignal } from "@preact/signals";
import { CircleCheck, Combine, HardDrive, RefreshCw, TriangleAlert, Usb } from "lucide-preact";
import { exchange, type Folder, type Merged } from "../api/exchange";
import { report } from "../app/session";
import { asTeacher } from "../app/teacher";
import { TEST } from "../app/testids";
import { language, texts } from "../i18n";
import { when } from "../i18n/format";
import { StillIn } from "./Deletion";
import { size } from "./size";
import { words } from "./words";

interface Properties {
  folders: readonly Folder[];
  results: Signal<Merged[]>;
  onMerged(): void;
  /** Look for sticks again, and for whose work is here. */
  onLook(): void;
}

/** Every file on every stick is to be merged, but those that a person has unticked. */
export function MergeBox({ folders, results, onMerged, onLook }: Properties) {
  const left = useSignal<ReadonlySet<string>>(new Set());
  const busy = useSignal<{ n: number; of: number } | null>(null);
  const say = words.value;
  const chosen = folders
    .flatMap((folder) => folder.files.map((file) => file.path))
    .filter((path) => !left.value.has(path));

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
  const deleteToo = async (path: string) => {
    const merged = await asTeacher(() => exchange.merge(path, true));
    if (merged) replace(merged);
    onMerged();
  };
  const toggle = (path: string) => {
    const next = new Set(left.value);
    if (!next.delete(path)) next.add(path);
    left.value = next;
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
        <FolderFiles key={folder.path} folder={folder} left={left.value} onToggle={toggle} />
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
              <Result
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

function FolderFiles(properties: {
  folder: Folder;
  left: ReadonlySet<string>;
  onToggle(path: string): void;
}) {
  const { folder, left, onToggle } = properties;
  const say = words.value;
  const Icon = folder.is_stick ? Usb : HardDrive;
  const now = new Date();
  return (
    <fieldset class="exchange__folder">
      <legend>
        <Icon class="icon" aria-hidden="true" />
        {folder.is_stick ? say.stick(folder.name) : say.folder(folder.name)}
        <FolderState folder={folder} />
      </legend>
      {folder.is_reachable && folder.files.length === 0 && (
        <p class="exchange__none">{say.noFiles}</p>
      )}
      {folder.files.map((file) => (
        <label key={file.path} class="exchange__file">
          <input
            type="checkbox"
            checked={!left.has(file.path)}
            aria-label={say.choose(file.name)}
            onChange={() => onToggle(file.path)}
          />
          <span class="exchange__name">{file.name}</span>
          <span class="exchange__about">
            {say.file(
              size(file.size_bytes, language.value),
              when(file.modified_at, now, language.value, texts.value),
            )}
          </span>
        </label>
      ))}
    </fieldset>
  );
}

function FolderState({ folder }: { folder: Folder }) {
  const say = words.value;
  if (!folder.is_reachable) return <span class="exchange__about">{say.unreachable}</span>;
  if (!folder.is_writable) return <span class="exchange__about">{say.readOnly}</span>;
  if (folder.free_bytes === null) return null;
  return <span class="exchange__about">{say.free(size(folder.free_bytes, language.value))}</span>;
}

interface ResultProps {
  merged: Merged;
  onDelete(): void;
  onKeep(): void;
}

/** What one file brought, or why it was refused. */
function Result({ merged, onDelete, onKeep }: ResultProps) {
  const { problem } = merged;
  const say = words.value;
  const Icon = problem ? TriangleAlert : CircleCheck;
  return (
    <li class={`exchange__result exchange__result--${problem ? "problem" : "good"}`}>
      <Icon class="icon" aria-hidden="true" />
      <p>
        {problem ? (
          <>
            <strong>{refusal(merged.name, problem.message)}</strong> {problem.remedy}
          </>
        ) : (
          outcome(merged)
        )}
      </p>
      {merged.would_delete && (
        <div class="deletion__sure" data-testid={TEST.wouldDelete}>
          <p>
            {say.doomed(
              merged.computer ?? merged.name,
              merged.would_delete.names.join(", "),
              `${say.programs(merged.would_delete.programs)}, ${say.runs(merged.would_delete.runs)}`,
            )}
          </p>
          <div class="exchange__buttons">
            <button
              type="button"
              class="button button--stop"
              data-testid={TEST.deleteToo}
              onClick={onDelete}
            >
              {say.deleteToo}
            </button>
            <button type="button" class="button" onClick={onKeep}>
              {say.keepHere}
            </button>
          </div>
        </div>
      )}
      {merged.left_in.length > 0 && (
        <div class="deletion__done">
          <StillIn paths={merged.left_in} />
        </div>
      )}
    </li>
  );
}

/** Most refusals name the file themselves. */
function refusal(name: string, message: string): string {
  return message.includes(name) ? message : `${name}: ${message}`;
}

function outcome({ computer, name, added, nothing_new }: Merged): string {
  const say = words.value;
  const who = computer ?? name;
  if (nothing_new) return say.nothingNew(who);
  const parts = [
    added.groups > 0 && say.groups(added.groups),
    added.programs > 0 && say.programs(added.programs),
    added.versions > 0 && say.versions(added.versions),
    added.runs > 0 && say.runs(added.runs),
  ].filter((part) => part !== false);
  return parts.length > 0 ? say.brought(who, parts.join(", ")) : say.only(who);
}
