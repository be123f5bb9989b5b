import { HardDrive, Usb } from "lucide-preact";
import type { FileFound, Folder } from "../../api/model";
import { language, texts } from "../../i18n";
import { FileRow } from "./FileRow";
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
