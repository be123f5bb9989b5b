/**
 * A token with a hyphen between digits or at its start: options of commands, times, names of files.
 */
const HYPHENATED = /(\S*(?:\d-\d|(?<!\S)[(“"]?-)\S*)/;
/** Maximum length of an unbroken token, in characters: a longer path may not fit on a line. */
const MAX_LENGTH = 30;

/** A sentence that never breaks an option such as `--json`, or a date, at its hyphen. */
export function Unbroken({ text }: { text: string }) {
  return (
    <>
      {text.split(HYPHENATED).map((part, index) =>
        index % 2 === 1 && part.length <= MAX_LENGTH ? (
          <span key={index} class="unbroken">
            {part}
          </span>
        ) : (
          part
        ),
      )}
    </>
  );
}
