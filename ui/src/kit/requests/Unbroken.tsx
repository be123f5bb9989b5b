/** Options of commands, times and names of files: what has a hyphen beside a digit or at its start. */
const HYPHENATED = /(\S*(?:\d-\d|(?<!\S)[(“"]?-)\S*)/;
/** A path may be longer than the line. */
const MAX_LENGTH = 30;

/** A sentence in which no option such as `--json`, and no date, is broken at its hyphen. */
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
