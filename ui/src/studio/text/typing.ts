/** Offsets of the caret or selection in a text. */
export interface Selected {
  readonly start: number;
  readonly end: number;
}

/** A replacement of a part of a text, and the selection after it. */
export interface Change {
  readonly from: number;
  readonly to: number;
  readonly text: string;
  readonly after: Selected;
}

const STEP = "    ";

/** Enter: the next line has the indentation of this one, one step more after a colon. */
export function newLine(text: string, { start, end }: Selected): Change {
  const line = text.slice(lineStart(text, start), start);
  const indent = /^[ ]*/.exec(line)?.[0] ?? "";
  const inner = /:\s*(#.*)?$/.test(line) ? STEP : "";
  const added = `\n${indent}${inner}`;
  return replaced(start, end, added);
}

/** Tab: indents the selected lines by a step; without a selection moves the caret to the next step. */
export function indent(text: string, { start, end }: Selected): Change {
  if (start === end) {
    const column = start - lineStart(text, start);
    return replaced(start, end, STEP.slice(column % STEP.length));
  }
  return moved(text, { start, end }, (line) => (line === "" ? line : STEP + line));
}

/** Shift+Tab: unindents the lines by at most a step. */
export function outdent(text: string, selected: Selected): Change {
  return moved(text, selected, (line) => line.replace(/^ {1,4}/, ""));
}

/** Offset of a line and a column, both from 1; the end of the text if there is no such position. */
export function offsetOf(text: string, line: number, column: number): number {
  const lines = text.split("\n");
  const before = lines.slice(0, line - 1).reduce((sum, one) => sum + one.length + 1, 0);
  const within = Math.min(Math.max(0, column - 1), lines[line - 1]?.length ?? 0);
  return Math.min(text.length, before + within);
}

const lineStart = (text: string, at: number) => text.lastIndexOf("\n", at - 1) + 1;

function replaced(from: number, to: number, text: string): Change {
  const end = from + text.length;
  return { from, to, text, after: { start: end, end } };
}

function moved(text: string, { start, end }: Selected, move: (line: string) => string): Change {
  const from = lineStart(text, start);
  // a selection that ends at the beginning of a line does not include that line
  const last = end > start && text[end - 1] === "\n" ? end - 1 : end;
  const next = text.indexOf("\n", last);
  const to = next < 0 ? text.length : next;
  const lines = text.slice(from, to).split("\n");
  const result = lines.map(move);
  const first = (result[0]?.length ?? 0) - (lines[0]?.length ?? 0);
  const added = result.join("\n");
  const grown = added.length - (to - from);
  const begin = start === from && start !== end ? from : Math.max(from, start + first);
  return { from, to, text: added, after: { start: begin, end: Math.max(begin, end + grown) } };
}
