import type { FileFound } from "../../api/model";
import { language, texts } from "../../i18n";
import { relativeTime } from "../../i18n/format";
import { size } from "./size";

interface FileRowProps {
  file: FileFound;
  isChosen: boolean;
  onToggle(): void;
}

/** A bundle file. Marks a file of this PC, which brings nothing, and an anonymous one, which duplicates groups. */
export function FileRow({ file, isChosen, onToggle }: FileRowProps) {
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
        {file.own && <span class="exchange__nameless">{labels.ownFile}</span>}
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
