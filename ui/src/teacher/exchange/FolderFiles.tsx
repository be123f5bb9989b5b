import { HardDrive, Usb } from "lucide-preact";
import type { FileFound, Folder } from "../../api/model";

import { language, texts } from "../../i18n";
import { relativeTime } from "../../i18n/format";
import { size } from "./size";

interface FolderFilesProps {
  folder: Folder;
  isChosen(file: FileFound): boolean;
  onToggle(file: FileFound): void;
}

/** The files on a stick or in the school's folder, with check boxes. */
export function FolderFiles({ folder, isChosen, onToggle }: FolderFilesProps) {
  const labels = texts.value.exchange;
  const Icon = folder.is_removable ? Usb : HardDrive;
  return (
    <fieldset class="exchange__folder shrinks">
      <legend>
        <Icon class="icon" aria-hidden="true" />
        {folder.is_removable
          ? labels.stick({ name: folder.name })
          : labels.folder({ name: folder.name })}
        <FolderState folder={folder} />
      </legend>
      {folder.is_reachable && folder.files.length === 0 && (
        <p class="exchange__hint">{labels.noFiles}</p>
      )}
      {folder.files.map((file) => (
        <FileRow
          key={file.path}
          file={file}
          isChosen={isChosen(file)}
          onToggle={() => onToggle(file)}
        />
      ))}
    </fieldset>
  );
}

interface FileRowProps {
  file: FileFound;
  isChosen: boolean;
  onToggle(): void;
}

/** A bundle file. Marks an anonymous bundle, because merging it duplicates groups. */
function FileRow({ file, isChosen, onToggle }: FileRowProps) {
  const labels = texts.value.exchange;
  return (
    <>
      <label class="exchange__file" data-testid="found-file">
        <input
          type="checkbox"
          checked={isChosen}
          aria-label={labels.choose({ name: file.name })}
          onChange={onToggle}
        />
        <span class="exchange__name">{file.name}</span>
        {file.anonymous && <span class="exchange__nameless">{labels.nameless}</span>}
        <span class="exchange__about">
          {labels.file({
            size: size(file.size_bytes, language.value),
            when: relativeTime(file.modified_at, new Date(), language.value, texts.value),
          })}
        </span>
      </label>
      {file.anonymous && isChosen && (
        <p class="notice-box" role="status">
          {labels.doubles}
        </p>
      )}
    </>
  );
}

function FolderState({ folder }: { folder: Folder }) {
  const labels = texts.value.exchange;
  if (!folder.is_reachable) return <span class="exchange__about">{labels.unreachable}</span>;
  if (!folder.is_writable) return <span class="exchange__about">{labels.readOnly}</span>;
  if (folder.free_bytes === null) return null;
  return (
    <span class="exchange__about">
      {labels.free({ size: size(folder.free_bytes, language.value) })}
    </span>
  );
}
