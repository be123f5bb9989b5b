import { FileInput } from "lucide-preact";
import type { FileFound, FolderList } from "../../api/model";
import { texts } from "../../i18n";
import { FileRow } from "./FileRow";

interface OpenedFileProps {
  opened: NonNullable<FolderList["opened"]>;
  isChosen(file: FileFound): boolean;
  onToggle(file: FileFound): void;
}

/** The file with which a person has opened PINEL, such as by a double click, or why it cannot be merged. */
export function OpenedFile({ opened: { file, problem }, isChosen, onToggle }: OpenedFileProps) {
  return (
    <fieldset class="exchange__folder shrinks" data-testid="opened-file">
      <legend>
        <FileInput class="icon" aria-hidden="true" />
        {texts.value.exchange.opened}
      </legend>
      {problem && (
        <p class="notice-box" role="status">
          <strong>{problem.message}</strong> {problem.remedy}
        </p>
      )}
      {file && <FileRow file={file} isChosen={isChosen(file)} onToggle={() => onToggle(file)} />}
    </fieldset>
  );
}
