import { HardDrive, Usb } from "lucide-preact";
import type { Folder, FoundFile } from "../api/exchange";
import { TEST } from "../app/testids";
import { language, texts } from "../i18n";
import { when } from "../i18n/format";
import { size } from "./size";
import { words } from "./words";

interface Properties {
  folder: Folder;
  isChosen(file: FoundFile): boolean;
  onToggle(file: FoundFile): void;
}

/** What lies on a stick or in the school's folder, to be ticked. */
export function FolderFiles({ folder, isChosen, onToggle }: Properties) {
  const say = words.value;
  const Icon = folder.is_stick ? Usb : HardDrive;
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
        <FileLine
          key={file.path}
          file={file}
          isChosen={isChosen(file)}
          onToggle={() => onToggle(file)}
        />
      ))}
    </fieldset>
  );
}

interface FileLineProps {
  file: FoundFile;
  isChosen: boolean;
  onToggle(): void;
}

/** A file without names is told as such: merged, it doubles the groups that are here. */
function FileLine({ file, isChosen, onToggle }: FileLineProps) {
  const say = words.value;
  return (
    <>
      <label class="exchange__file" data-testid={TEST.foundFile}>
        <input
          type="checkbox"
          checked={isChosen}
          aria-label={say.choose(file.name)}
          onChange={onToggle}
        />
        <span class="exchange__name">{file.name}</span>
        {file.anonymous && <span class="exchange__nameless">{say.nameless}</span>}
        <span class="exchange__about">
          {say.file(
            size(file.size_bytes, language.value),
            when(file.modified_at, new Date(), language.value, texts.value),
          )}
        </span>
      </label>
      {file.anonymous && isChosen && (
        <p class="exchange__doubles" role="status">
          {say.doubles}
        </p>
      )}
    </>
  );
}

function FolderState({ folder }: { folder: Folder }) {
  const say = words.value;
  if (!folder.is_reachable) return <span class="exchange__about">{say.unreachable}</span>;
  if (!folder.is_writable) return <span class="exchange__about">{say.readOnly}</span>;
  if (folder.free_bytes === null) return null;
  return <span class="exchange__about">{say.free(size(folder.free_bytes, language.value))}</span>;
}
