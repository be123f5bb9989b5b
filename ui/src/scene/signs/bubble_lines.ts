/** Characters of a line of a speech bubble. */
const LINE_LENGTH = 24;
const MORE = "…";
const RIGHT_TO_LEFT = /\p{Script=Arabic}|\p{Script=Hebrew}|\p{Script=Syriac}|\p{Script=Thaana}/u;

/** The lines of a text in a speech bubble; what does not fit is replaced by an ellipsis. */
export function bubbleLines(text: string, maxLines = 2): string[] {
  const lines: string[] = [];
  for (const part of text.trim().split(/\s+/).flatMap(pieces)) {
    const line = lines.at(-1);
    if (line !== undefined && length(line) + 1 + length(part) <= LINE_LENGTH)
      lines[lines.length - 1] = `${line} ${part}`;
    else lines.push(part);
  }
  if (lines.length <= maxLines) return lines;
  const last = characters(lines[maxLines - 1] ?? "").slice(0, LINE_LENGTH - 1);
  return [...lines.slice(0, maxLines - 1), `${last.join("").trimEnd()}${MORE}`];
}

/** Whether the first letter of a text belongs to a script that is written from right to left. */
export function isRightToLeft(text: string): boolean {
  const letter = /\p{L}/u.exec(text)?.[0] ?? "";
  return RIGHT_TO_LEFT.test(letter);
}

/** Characters as people count them: an emoji of several code points is one. */
export function characters(text: string): string[] {
  if (!("Segmenter" in Intl)) return [...text];
  return [...new Intl.Segmenter().segment(text)].map(({ segment }) => segment);
}

const length = (text: string) => characters(text).length;

/** A word that is longer than a line, in pieces that fit. */
function pieces(part: string): string[] {
  const all = characters(part);
  const n = Math.ceil(all.length / LINE_LENGTH);
  return Array.from({ length: n }, (_, index) =>
    all.slice(index * LINE_LENGTH, (index + 1) * LINE_LENGTH).join(""),
  );
}
